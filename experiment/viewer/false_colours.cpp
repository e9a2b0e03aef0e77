// Oklab's path, and a logarithm undone.
#include "experiment/viewer/false_colours.h"

#include "renderer/contract.h"
#include "renderer/methods/catalogue.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace experiment::viewer {

namespace {

// Ends of the path.  With more chroma it would leave sRGB's gamut near its dark end.
constexpr double dark = 0.25, pale = 0.93; // lightness
constexpr double chroma = 0.11;
constexpr double violet_degrees = -40, yellow_degrees = 100;

// By so much a scale may fall short of what it is for: nobody sees it, and 10.002 mm get a scale of
// 10 mm instead of 20.
constexpr double overshoot = 1e-3;

// How far g^2 may be from r b: a thousand times float's rounding in three exponentials.
constexpr double consistency = 1e-3;

double cube(double x) {
    return x * x * x;
}

/// The larger one, or NaN where one of them is that: a broken pixel has to show.
double larger(double a, double b) {
    return b <= a ? a : std::isnan(a) ? a : b;
}

} // namespace

renderer::LinearRgb false_colour(double t) {
    t = std::clamp(t, 0.0, 1.0);
    const double L = dark + t * (pale - dark);
    const double hue =
        (violet_degrees + t * (yellow_degrees - violet_degrees)) * std::numbers::pi / 180;
    const double a = chroma * std::cos(hue), b = chroma * std::sin(hue);
    const double l = cube(L + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(L - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(L - 0.0894841775 * a - 1.2914855480 * b);
    return {static_cast<float>(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            static_cast<float>(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            static_cast<float>(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

double round_scale(double value) {
    if (!(value > 0) || !std::isfinite(value))
        return 1;
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (value <= digit * decade * (1 + overshoot))
            return digit * decade;
    return 10 * decade;
}

// sigma_tr^2 = 3 sigma_a (sigma_a + sigma_s'); with sigma_s' = sigma_tr its positive root is
// sigma_a = sigma_tr (sqrt(7/3) - 1)/2.
renderer::Material thickness_probe(renderer::Millimetres reach) {
    EXPECTS(reach.value > 0);
    const double s = 1 / reach.value;
    const double share = (std::sqrt(7.0 / 3.0) - 1) / 2;
    return {.medium = {.sigma_a = {share * s, 2 * share * s, 3 * share * s},
                       .sigma_s_reduced = {s, 2 * s, 3 * s},
                       .index = 1.3},
            .reflectance = {.ambient = {}, .diffuse = {}, .specular = {}, .scatter = {1, 1, 1}}};
}

std::optional<double> thickness_of(std::span<const float, 4> rgba, renderer::Millimetres reach) {
    const double r = static_cast<double>(rgba[0]), g = static_cast<double>(rgba[1]),
                 b = static_cast<double>(rgba[2]);
    const bool follows_one_length = std::abs(g * g - r * b) <= consistency * g * g;
    if (!(rgba[3] > 0) || !(b > 0) || !follows_one_length)
        return std::nullopt;
    return std::max(reach.value * std::log(r / g), 0.0);
}

ThicknessSeen thickness_seen(std::span<const float> rgba, renderer::Millimetres reach) {
    ThicknessSeen seen;
    for (std::size_t i = 0; i + 4 <= rgba.size(); i += 4) {
        const std::span<const float, 4> pixel(&rgba[i], 4);
        seen.pixels += pixel[3] > 0 ? 1 : 0;
        if (const auto d = thickness_of(pixel, reach)) {
            ++seen.known;
            seen.mean += *d;
            seen.most = std::max(seen.most, *d);
        }
    }
    if (seen.known > 0)
        seen.mean /= static_cast<double>(seen.known);
    return seen;
}

bool has_thickness(const ThicknessSeen& seen) {
    return 100 * seen.known >= 99 * seen.pixels;
}

ErrorSeen error_seen(std::span<const float> left, std::span<const float> right) {
    EXPECTS(left.size() == right.size());
    ErrorSeen seen;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i + 4 <= left.size(); i += 4) {
        if (!(left[i + 3] > 0) && !(right[i + 3] > 0))
            continue;
        double error = 0;
        for (std::size_t channel = i; channel < i + 3; ++channel)
            error = larger(error, static_cast<double>(std::abs(left[channel] - right[channel])));
        ++pixels;
        seen.mean += error;
        seen.most = larger(seen.most, error);
    }
    if (pixels > 0)
        seen.mean /= static_cast<double>(pixels);
    return seen;
}

bool has_physical_law(std::string_view method) {
    const auto* known = renderer::methods::find_method(method);
    return known != nullptr &&
           std::ranges::any_of(known->dials, [](const renderer::methods::Dial& dial) {
               return dial.name == "law" && std::ranges::count(dial.names, "physical") > 0;
           });
}

} // namespace experiment::viewer
