// FLIP, step by step as the papers tell it; their symbols.
#include "renderer/imaging/flip.h"

#include "renderer/contract.h"
#include "renderer/imaging/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace renderer::imaging {

namespace {

// [Andersson2020, section 4]
constexpr double q_c = 0.7, p_c = 0.4, p_t = 0.95; // colour: exponent, knee and its height
constexpr double q_f = 0.5, feature_width = 0.082; // features: exponent, degrees

using Colour = std::array<double, 3>;
using Planes = std::array<Plane, 3>;

// Rec. 709 primaries and the D65 white as the rational numbers their definition gives.
constexpr std::array<Colour, 3> xyz_from_rgb{
    {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
     {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
     {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

Colour times(const std::array<Colour, 3>& m, const Colour& v) {
    Colour product{};
    for (std::size_t i = 0; i < 3; ++i)
        product[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return product;
}

const Colour white = times(xyz_from_rgb, {1, 1, 1});

std::array<Colour, 3> inverse(const std::array<Colour, 3>& m) {
    const auto minor = [&](std::size_t r, std::size_t c) {
        const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
    };
    const double det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    std::array<Colour, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            result[i][j] = minor(j, i) / det;
    return result;
}

const std::array<Colour, 3> rgb_from_xyz = inverse(xyz_from_rgb);

/// An opponent space that is linear in light: brightness, red-green, blue-yellow.
Colour opponent(const Colour& rgb) {
    const Colour xyz = times(xyz_from_rgb, rgb);
    const double x = xyz[0] / white[0], y = xyz[1] / white[1], z = xyz[2] / white[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Colour rgb_from_opponent(const Colour& c) {
    const double y = (c[0] + 16) / 116;
    return times(rgb_from_xyz,
                 {white[0] * (c[1] / 500 + y), white[1] * y, white[2] * (y - c[2] / 200)});
}

Colour lab(const Colour& rgb) {
    constexpr double delta = 6.0 / 29;
    const auto f = [](double t) {
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
    };
    const Colour xyz = times(xyz_from_rgb, rgb);
    const double x = f(xyz[0] / white[0]), y = f(xyz[1] / white[1]), z = f(xyz[2] / white[2]);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Colours look paler where they are dark.
Colour hunt_adjusted(const Colour& lab_colour) {
    const double paler = 0.01 * lab_colour[0];
    return {lab_colour[0], paler * lab_colour[1], paler * lab_colour[2]};
}

/// For large differences: city blocks in lightness, Euclid in colour.
double hyab(const Colour& a, const Colour& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

const double greatest_colour_difference =
    std::pow(hyab(hunt_adjusted(lab({0, 1, 0})), hunt_adjusted(lab({0, 0, 1}))), q_c);

double colour_difference(const Colour& rgb_a, const Colour& rgb_b) {
    const double d = std::pow(hyab(hunt_adjusted(lab(rgb_a)), hunt_adjusted(lab(rgb_b))), q_c);
    const double knee = p_c * greatest_colour_difference;
    if (d < knee)
        return p_t / knee * d;
    return p_t + (d - knee) / (greatest_colour_difference - knee) * (1 - p_t);
}

/// a exp(-(pi x)^2 / b) in frequency is a Gaussian in space.
struct Sensitivity {
    double a1, b1, a2, b2;
};

constexpr std::array<Sensitivity, 3> sensitivities{
    {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};

Kernel gaussian(int radius, double pixels_per_degree, double b) {
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i) {
        const double x = i / pixels_per_degree;
        kernel.push_back(
            static_cast<float>(std::exp(-std::numbers::pi * std::numbers::pi * x * x / b)));
    }
    return kernel;
}

double total(const Kernel& kernel) {
    double sum = 0;
    for (const float weight : kernel)
        sum += static_cast<double>(weight);
    return sum;
}

/// As blurred as the eye sees it: a sum of two round Gaussians, each separable.
Plane blurred(const Plane& plane, const Sensitivity& s, double pixels_per_degree) {
    constexpr double widest = 0.04;
    const int radius = static_cast<int>(std::ceil(
        3 * std::sqrt(widest / (2 * std::numbers::pi * std::numbers::pi)) * pixels_per_degree));
    const Kernel first = gaussian(radius, pixels_per_degree, s.b1);
    const Kernel second = gaussian(radius, pixels_per_degree, s.b2);
    // The published program scales both as lines, not as discs; its numbers are the standard.
    const double w1 = s.a1 * std::sqrt(std::numbers::pi / s.b1);
    const double w2 = s.a2 * std::sqrt(std::numbers::pi / s.b2);
    const double t1 = total(first), t2 = total(second);
    const double all = w1 * t1 * t1 + w2 * t2 * t2;
    Plane result = filtered(plane, first, first);
    for (auto& value : result.values)
        value *= static_cast<float>(w1 / all);
    if (w2 == 0)
        return result;
    const Plane other = filtered(plane, second, second);
    for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] += static_cast<float>(w2 / all) * other.values[i];
    return result;
}

/// Positive weights sum to 1, negative ones to -1.
void balance(Kernel& kernel) {
    double positive = 0, negative = 0;
    for (const float weight : kernel)
        (weight > 0 ? positive : negative) += static_cast<double>(weight);
    for (auto& weight : kernel)
        weight =
            static_cast<float>(static_cast<double>(weight) / (weight > 0 ? positive : -negative));
}

struct Features {
    Plane edges, points;
};

Plane magnitude(const Plane& x, const Plane& y) {
    Plane result(x.width, x.height);
    for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = std::hypot(x.values[i], y.values[i]);
    return result;
}

Features features(const Plane& brightness, double pixels_per_degree) {
    const double sd = 0.5 * feature_width * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * sd));
    Kernel smooth, slope, bend;
    for (int i = -radius; i <= radius; ++i) {
        const double g = std::exp(-i * i / (2 * sd * sd));
        smooth.push_back(static_cast<float>(g));
        slope.push_back(static_cast<float>(-i * g));
        bend.push_back(static_cast<float>((i * i / (sd * sd) - 1) * g));
    }
    const auto sum = static_cast<float>(total(smooth));
    for (auto& weight : smooth)
        weight /= sum;
    balance(slope);
    balance(bend);
    return {magnitude(filtered(brightness, slope, smooth), filtered(brightness, smooth, slope)),
            magnitude(filtered(brightness, bend, smooth), filtered(brightness, smooth, bend))};
}

Planes planes(const LinearImage& image) {
    Planes result{Plane(image.width, image.height), Plane(image.width, image.height),
                  Plane(image.width, image.height)};
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto& p = image.pixels[i];
        EXPECTS(std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b));
        const auto shown = [](float x) { return std::clamp(static_cast<double>(x), 0.0, 1.0); };
        const Colour c = opponent({shown(p.r), shown(p.g), shown(p.b)});
        for (std::size_t k = 0; k < 3; ++k)
            result[k].values[i] = static_cast<float>(c[k]);
    }
    return result;
}

/// What FLIP compares of one picture.
struct Seen {
    Planes colours; // blurred
    Features of;

    Seen(const LinearImage& image, double pixels_per_degree) : colours(planes(image)) {
        Plane brightness = colours[0];
        for (auto& value : brightness.values)
            value = (value + 16) / 116;
        of = features(brightness, pixels_per_degree);
        for (std::size_t k = 0; k < 3; ++k)
            colours[k] = blurred(colours[k], sensitivities[k], pixels_per_degree);
    }

    Colour rgb(std::size_t i) const {
        Colour c = rgb_from_opponent({static_cast<double>(colours[0].values[i]),
                                      static_cast<double>(colours[1].values[i]),
                                      static_cast<double>(colours[2].values[i])});
        for (auto& channel : c)
            channel = std::clamp(channel, 0.0, 1.0);
        return c;
    }
};

double feature_difference(const Features& a, const Features& b, std::size_t i) {
    const float edges = std::abs(a.edges.values[i] - b.edges.values[i]);
    const float points = std::abs(a.points.values[i] - b.points.values[i]);
    const double d = static_cast<double>(std::max(edges, points));
    return std::pow(d / std::numbers::sqrt2, q_f);
}

LinearImage exposed(const LinearImage& image, double stop) {
    LinearImage result = image;
    const double factor = std::exp2(stop);
    const auto shown = [factor](float light) {
        return static_cast<float>(tone_mapped(factor * static_cast<double>(light)));
    };
    for (auto& p : result.pixels)
        p = {shown(p.r), shown(p.g), shown(p.b)};
    return result;
}

// A rational fit to the ACES curve with its customary scaling by 0.6: (a x^2 + b x) / (c x^2 + d x
// + e).
constexpr double ace_a = 0.6 * 0.6 * 2.51, ace_b = 0.6 * 0.03, ace_c = 0.6 * 0.6 * 2.43,
                 ace_d = 0.6 * 0.59, ace_e = 0.14;

/// The light that the tone mapper sends to `t`.
double light_from_tone(double t) {
    const double a = ace_a - t * ace_c, b = ace_b - t * ace_d, c = -t * ace_e;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

} // namespace

Plane ldr_flip(const LinearImage& test, const LinearImage& reference, double pixels_per_degree) {
    EXPECTS(test.width == reference.width && test.height == reference.height);
    EXPECTS(pixels_per_degree > 0);
    const Seen a(test, pixels_per_degree), b(reference, pixels_per_degree);
    Plane result(test.width, test.height);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        const double colour = colour_difference(a.rgb(i), b.rgb(i));
        const double feature = feature_difference(a.of, b.of, i);
        result.values[i] = static_cast<float>(std::pow(colour, 1 - std::min(feature, 1.0)));
    }
    return result;
}

double tone_mapped(double light) {
    const double x = std::max(light, 0.0);
    return std::clamp((ace_a * x * x + ace_b * x) / (ace_c * x * x + ace_d * x + ace_e), 0.0, 1.0);
}

ExposureRange exposure_range(const LinearImage& reference) {
    std::vector<double> brightness;
    for (const auto& pixel : reference.pixels)
        brightness.push_back(std::max(luminance(pixel), 0.0));
    std::ranges::sort(brightness);
    EXPECTS(!brightness.empty() && brightness.back() > 0);
    // a picture more than half black: the median of what is lit
    double median = brightness[brightness.size() / 2];
    if (median == 0)
        median = *std::ranges::upper_bound(brightness, 0.0);
    const double mapped = light_from_tone(0.85);
    const double first = std::log2(mapped / brightness.back());
    const double last = std::max(first, std::log2(mapped / median));
    return {first, last, std::max(2, static_cast<int>(std::ceil(last - first)))};
}

Plane hdr_flip(const LinearImage& test,
               const LinearImage& reference,
               double pixels_per_degree,
               const ExposureRange& exposures) {
    EXPECTS(exposures.count >= 2);
    Plane greatest(test.width, test.height);
    for (int i = 0; i < exposures.count; ++i) {
        const double stop =
            exposures.first + (exposures.last - exposures.first) * i / (exposures.count - 1);
        const Plane error =
            ldr_flip(exposed(test, stop), exposed(reference, stop), pixels_per_degree);
        for (std::size_t p = 0; p < greatest.values.size(); ++p)
            greatest.values[p] = std::max(greatest.values[p], error.values[p]);
    }
    return greatest;
}

} // namespace renderer::imaging
