// Errors of pictures.
#include "renderer/imaging/errors.h"

#include "renderer/contract.h"
#include "renderer/imaging/brightness.h"
#include "renderer/imaging/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace renderer::imaging {

namespace {

constexpr double black = 1e-4; // a mean luminance below it: nothing to compare

std::array<double, 3> channels(LinearRgb light) {
    return {static_cast<double>(light.r), static_cast<double>(light.g),
            static_cast<double>(light.b)};
}

Expected<void>
check_finite(std::string_view name, const LinearImage& image, std::span<const std::size_t> mask) {
    const auto width = static_cast<std::size_t>(image.width);
    for (const auto pixel : mask) {
        EXPECTS(pixel < image.pixels.size());
        const auto& light = image.pixels[pixel];
        if (!std::isfinite(light.r) || !std::isfinite(light.g) || !std::isfinite(light.b))
            return tl::unexpected(fmt::format("{}: pixel ({}, {}) is ({}, {}, {}), expected finite "
                                              "light",
                                              name, pixel % width, pixel / width, light.r, light.g,
                                              light.b));
    }
    if (!(mean_luminance(image, mask) >= black))
        return tl::unexpected(fmt::format("{} is black: its mean luminance is {:.3g}, expected at "
                                          "least {:g}",
                                          name, mean_luminance(image, mask), black));
    return {};
}

Expected<void> check_pair(const LinearImage& test,
                          const LinearImage& reference,
                          std::span<const std::size_t> mask) {
    if (test.width != reference.width || test.height != reference.height)
        return tl::unexpected(fmt::format(
            "the picture is {} x {} pixels and the reference {} x {}, expected one size",
            test.width, test.height, reference.width, reference.height));
    if (mask.empty())
        return tl::unexpected(std::string("the mask is empty, expected pixels to compare over"));
    return check_finite("the picture", test, mask).and_then([&] {
        return check_finite("the reference", reference, mask);
    });
}

struct Box {
    int left, top, right, bottom; // the last ones within
};

Box bounding_box(std::span<const std::size_t> mask, int width) {
    Box box{width, std::numeric_limits<int>::max(), 0, 0};
    for (const auto pixel : mask) {
        const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
        box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x),
               std::max(box.bottom, y)};
    }
    return box;
}

/// Around the mask a picture may hold anything, even what is no number: there it is black.
LinearImage cropped(const LinearImage& image, const Box& box, std::span<const std::size_t> mask) {
    LinearImage crop{box.right - box.left + 1, box.bottom - box.top + 1, {}, {}};
    for (int y = box.top; y <= box.bottom; ++y)
        for (int x = box.left; x <= box.right; ++x) {
            const auto pixel = static_cast<std::size_t>(y * image.width + x);
            const auto& p = image.pixels[pixel];
            const bool is_light = std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b);
            crop.pixels.push_back(is_light ? p : LinearRgb{});
            crop.coverage.push_back(std::ranges::binary_search(mask, pixel) ? 1.0f : 0.0f);
        }
    return crop;
}

double mean_over(const Plane& plane, const std::vector<std::size_t>& mask) {
    double sum = 0;
    for (const auto pixel : mask)
        sum += static_cast<double>(plane.values[pixel]);
    return sum / static_cast<double>(mask.size());
}

void add_pixelwise(ImageErrors& errors,
                   const LinearImage& test,
                   const LinearImage& reference,
                   const std::vector<std::size_t>& mask) {
    double squares = 0, sizes = 0, relative = 0, encoded = 0;
    for (const auto pixel : mask) {
        const auto x = channels(test.pixels[pixel]), y = channels(reference.pixels[pixel]);
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = x[k] - y[k];
            squares += d * d;
            sizes += std::abs(d);
            relative += d * d / (y[k] * y[k] + 0.01);
            const double e = srgb_from_linear(x[k]) - srgb_from_linear(y[k]);
            encoded += e * e;
        }
    }
    const double n = 3 * static_cast<double>(mask.size());
    errors.rmse = std::sqrt(squares / n);
    errors.mae = sizes / n;
    errors.rel_mse = relative / n;
    errors.psnr =
        encoded == 0 ? std::numeric_limits<double>::infinity() : -10 * std::log10(encoded / n);
}

Plane encoded_brightness(const LinearImage& image) {
    Plane plane(image.width, image.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto e = encode(image.pixels[i]);
        plane.values[i] = static_cast<float>(luminance({e.r, e.g, e.b}));
    }
    return plane;
}

Plane product(const Plane& a, const Plane& b) {
    Plane result(a.width, a.height);
    for (std::size_t i = 0; i < a.values.size(); ++i)
        result.values[i] = a.values[i] * b.values[i];
    return result;
}

Kernel gaussian_window() {
    Kernel window;
    double sum = 0;
    for (int i = -5; i <= 5; ++i)
        sum += std::exp(-i * i / (2 * 1.5 * 1.5));
    for (int i = -5; i <= 5; ++i)
        window.push_back(static_cast<float>(std::exp(-i * i / (2 * 1.5 * 1.5)) / sum));
    return window;
}

} // namespace

Expected<ImageErrors> image_errors(const LinearImage& test,
                                   const LinearImage& reference,
                                   std::span<const std::size_t> mask,
                                   const ErrorSettings& settings) {
    double gain = 1;
    if (settings.brightness == Brightness::Equalised) {
        const auto needed = brightness_gain(test, reference, mask);
        if (!needed)
            return tl::unexpected(needed.error());
        gain = *needed;
    } else if (const auto checked = check_pair(test, reference, mask); !checked) {
        return tl::unexpected(checked.error());
    }
    const Box box = bounding_box(mask, test.width);
    const LinearImage x = cropped(brightened(test, gain), box, mask);
    const LinearImage y = cropped(reference, box, mask);
    const auto inner = covered_pixels(y.coverage);
    ImageErrors errors;
    add_pixelwise(errors, x, y, inner);
    errors.ssim = mean_over(ssim_map(x, y), inner);
    errors.ldr_flip = mean_over(ldr_flip(x, y, settings.pixels_per_degree), inner);
    errors.exposures = exposure_range(y);
    errors.hdr_flip =
        mean_over(hdr_flip(x, y, settings.pixels_per_degree, errors.exposures), inner);
    return errors;
}

Expected<double> brightness_gain(const LinearImage& test,
                                 const LinearImage& reference,
                                 std::span<const std::size_t> mask) {
    if (const auto checked = check_pair(test, reference, mask); !checked)
        return tl::unexpected(checked.error());
    return mean_luminance(reference, mask) / mean_luminance(test, mask);
}

LinearImage brightened(const LinearImage& image, double gain) {
    LinearImage result = image;
    const auto factor = static_cast<float>(gain);
    for (auto& p : result.pixels)
        p = {factor * p.r, factor * p.g, factor * p.b};
    return result;
}

Plane ssim_map(const LinearImage& test, const LinearImage& reference) {
    EXPECTS(test.width == reference.width && test.height == reference.height);
    constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    const Kernel window = gaussian_window();
    const Plane x = encoded_brightness(test), y = encoded_brightness(reference);
    const Plane mx = filtered(x, window, window), my = filtered(y, window, window);
    const Plane xx = filtered(product(x, x), window, window);
    const Plane yy = filtered(product(y, y), window, window);
    const Plane xy = filtered(product(x, y), window, window);
    Plane result(test.width, test.height);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        const auto a = static_cast<double>(mx.values[i]), b = static_cast<double>(my.values[i]);
        const double va = static_cast<double>(xx.values[i]) - a * a;
        const double vb = static_cast<double>(yy.values[i]) - b * b;
        const double vab = static_cast<double>(xy.values[i]) - a * b;
        result.values[i] = static_cast<float>((2 * a * b + c1) * (2 * vab + c2) /
                                              ((a * a + b * b + c1) * (va + vb + c2)));
    }
    return result;
}

LinearImage error_map(const Plane& values, double low, double high) {
    EXPECTS(high > low);
    // encoded colours of rising lightness
    constexpr std::array<std::array<double, 3>, 5> steps{{{0.05, 0.03, 0.20},
                                                          {0.23, 0.20, 0.55},
                                                          {0.13, 0.47, 0.55},
                                                          {0.37, 0.75, 0.38},
                                                          {0.99, 0.91, 0.30}}};
    LinearImage map{values.width, values.height, {}, {}};
    for (const float value : values.values) {
        const double t = std::clamp((static_cast<double>(value) - low) / (high - low), 0.0, 1.0);
        const double place = 4 * t;
        const auto i = std::min<std::size_t>(3, static_cast<std::size_t>(place));
        const double u = place - static_cast<double>(i);
        std::array<float, 3> c{};
        for (std::size_t k = 0; k < 3; ++k)
            c[k] =
                static_cast<float>(linear_from_srgb((1 - u) * steps[i][k] + u * steps[i + 1][k]));
        map.pixels.push_back({c[0], c[1], c[2]});
        map.coverage.push_back(1);
    }
    return map;
}

} // namespace renderer::imaging
