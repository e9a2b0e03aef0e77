// Brightness matching by means over the object, in linear light.
#include "renderer/imaging/brightness.h"

#include "renderer/contract.h"
#include "renderer/imaging/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace renderer::imaging {

namespace {

constexpr float whole_coverage = 0.999F;
constexpr double black = 1e-4;          // a mean below it is noise that a gain would amplify
constexpr double clipping_limit = 1e-3; // of the mask's pixels
constexpr double lowering = 0.95;
constexpr double encoded_tolerance = 2e-3;

// Sums of some 10^5 luminances in double are good to 1e-11: no compensation needed.
template <class LightAt>
double mean_over(std::span<const std::size_t> mask, LightAt&& light_of) {
    EXPECTS(!mask.empty());
    double sum = 0;
    for (const auto pixel : mask)
        sum += luminance(light_of(pixel));
    return sum / static_cast<double>(mask.size());
}

LinearRgb scaled(LinearRgb light, double gain) {
    const auto channel = [gain](float value) {
        return static_cast<float>(gain * static_cast<double>(value));
    };
    return {channel(light.r), channel(light.g), channel(light.b)};
}

LinearRgb clipped(LinearRgb light) {
    return {std::min(light.r, 1.0F), std::min(light.g, 1.0F), std::min(light.b, 1.0F)};
}

bool is_light(LinearRgb value) {
    const auto good = [](float channel) { return std::isfinite(channel) && channel >= 0; };
    return good(value.r) && good(value.g) && good(value.b);
}

double clipped_share(const LinearImage& image, std::span<const std::size_t> mask, double gain) {
    const auto clips = [&](std::size_t pixel) {
        const auto light = scaled(image.pixels[pixel], gain);
        return std::max({light.r, light.g, light.b}) > 1.0F;
    };
    return static_cast<double>(std::ranges::count_if(mask, clips)) /
           static_cast<double>(mask.size());
}

Expected<double> usable_mean(const NamedImage& picture, std::span<const std::size_t> mask) {
    const LinearImage& image = picture.image;
    for (const auto pixel : mask) {
        EXPECTS(pixel < image.pixels.size());
        const auto& light = image.pixels[pixel];
        const auto width = static_cast<std::size_t>(image.width);
        if (!is_light(light))
            return tl::unexpected(fmt::format(
                "picture '{}': pixel ({}, {}) is ({}, {}, {}), expected finite light >= 0",
                picture.name, pixel % width, pixel / width, light.r, light.g, light.b));
    }
    const double mean = mean_luminance(image, mask);
    if (!(mean >= black))
        return tl::unexpected(
            fmt::format("picture '{}' is black: its mean luminance is {:.3g}, expected at least "
                        "{:g}; give the scene light or an ambient term",
                        picture.name, mean, black));
    return mean;
}

double geometric_mean(std::span<const double> values) {
    double sum = 0;
    for (const double value : values)
        sum += std::log(value);
    return std::exp(sum / static_cast<double>(values.size()));
}

// Ends, because at most one pixel in 1000 can be brighter than 1000 times a picture's mean.
double unclipped_target(std::span<const NamedImage> pictures,
                        std::span<const std::size_t> mask,
                        std::span<const double> means,
                        double target) {
    for (std::size_t i = 0; i < pictures.size();)
        if (clipped_share(pictures[i].image, mask, target / means[i]) > clipping_limit)
            target *= lowering;
        else
            ++i; // a lower target will not make this picture clip again
    return target;
}

BrightnessMatch
match(const LinearImage& image, std::span<const std::size_t> mask, double mean, double target) {
    const double gain = target / mean;
    const double after = mean_over(
        mask, [&](std::size_t pixel) { return clipped(scaled(image.pixels[pixel], gain)); });
    return {mean, gain, target, clipped_share(image, mask, gain), after};
}

} // namespace

std::vector<std::size_t> covered_pixels(std::span<const float> coverage) {
    std::vector<std::size_t> mask;
    for (std::size_t pixel = 0; pixel < coverage.size(); ++pixel)
        if (coverage[pixel] >= whole_coverage)
            mask.push_back(pixel);
    return mask;
}

double mean_luminance(const LinearImage& image, std::span<const std::size_t> mask) {
    return mean_over(mask, [&](std::size_t pixel) {
        EXPECTS(pixel < image.pixels.size());
        return image.pixels[pixel];
    });
}

double mean_luminance(const EncodedImage& image, std::span<const std::size_t> mask) {
    return mean_over(mask, [&](std::size_t pixel) { return light_at(image, pixel); });
}

Expected<std::vector<BrightnessMatch>> match_brightness(std::span<const NamedImage> pictures,
                                                        std::span<const std::size_t> mask,
                                                        std::optional<double> reference_mean) {
    EXPECTS(!pictures.empty());
    if (mask.empty())
        return tl::unexpected(std::string("no pixel is wholly covered by the object, expected some "
                                          "to match brightness over; move the camera nearer"));
    std::vector<double> means;
    for (const auto& picture : pictures) {
        EXPECTS(picture.image.get().pixels.size() == pictures.front().image.get().pixels.size());
        const auto mean = usable_mean(picture, mask);
        if (!mean)
            return tl::unexpected(mean.error());
        means.push_back(*mean);
    }
    const double wanted = reference_mean.value_or(geometric_mean(means));
    EXPECTS(wanted >= black);
    const double target = unclipped_target(pictures, mask, means, wanted);
    std::vector<BrightnessMatch> matches;
    for (std::size_t i = 0; i < pictures.size(); ++i)
        matches.push_back(match(pictures[i].image, mask, means[i], target));
    return matches;
}

LinearImage composite_over_grey(const LinearImage& image, double gain, int surround_code) {
    EXPECTS(surround_code >= 0 && surround_code <= 255);
    EXPECTS(image.coverage.size() == image.pixels.size());
    const auto grey = static_cast<float>(linear_from_srgb(surround_code / 255.0));
    LinearImage opaque{
        image.width, image.height, {}, std::vector<float>(image.pixels.size(), 1.0F)};
    opaque.pixels.reserve(image.pixels.size());
    for (std::size_t pixel = 0; pixel < image.pixels.size(); ++pixel) {
        const auto light = scaled(image.pixels[pixel], gain);
        const float behind = (1 - image.coverage[pixel]) * grey;
        opaque.pixels.push_back({light.r + behind, light.g + behind, light.b + behind});
    }
    return opaque;
}

Expected<double> check_encoded_mean(std::string_view name,
                                    const EncodedImage& image,
                                    std::span<const std::size_t> mask,
                                    double target) {
    const double mean = mean_luminance(image, mask);
    if (!(std::abs(mean - target) <= encoded_tolerance * target))
        return tl::unexpected(fmt::format("picture '{}': mean luminance after encoding is {:.6g}, "
                                          "expected {:.6g} within {:g} %",
                                          name, mean, target, 100 * encoded_tolerance));
    return mean;
}

} // namespace renderer::imaging
