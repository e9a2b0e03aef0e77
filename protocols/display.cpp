// Code values and light.
#include "protocols/display.h"

#include "protocols/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace protocols {

namespace {

double table_luminance(const std::vector<GreyStep>& steps, int code) {
    EXPECTS(steps.size() >= 2 && steps.front().code == 0 && steps.back().code == 255);
    const auto above = std::find_if(steps.begin() + 1, steps.end(),
                                    [&](const GreyStep& step) { return step.code >= code; });
    const auto below = above - 1;
    const double share = static_cast<double>(code - below->code) / (above->code - below->code);
    return (below->cd_m2 + share * (above->cd_m2 - below->cd_m2)) / steps.back().cd_m2;
}

std::optional<double> number_in(const std::string& text) {
    double number = 0;
    const auto* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    return error == std::errc() && end == last ? std::optional(number) : std::nullopt;
}

} // namespace

std::string name_of(const Eotf& eotf) {
    switch (eotf.kind) {
    case Eotf::Kind::Srgb:
        return "srgb";
    case Eotf::Kind::Gamma:
        return fmt::format("gamma {}", eotf.gamma);
    case Eotf::Kind::Measured:
        break;
    }
    return "table " + eotf.file;
}

double relative_luminance(const Eotf& eotf, int code) {
    EXPECTS(code >= 0 && code <= 255);
    const double v = code / 255.0;
    switch (eotf.kind) {
    case Eotf::Kind::Srgb:
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    case Eotf::Kind::Gamma:
        return std::pow(v, eotf.gamma);
    case Eotf::Kind::Measured:
        break;
    }
    return table_luminance(eotf.steps, code);
}

int nearest_code(const Eotf& eotf, double luminance) {
    EXPECTS(luminance >= 0 && luminance <= 1);
    int nearest = 0;
    for (int code = 1; code <= 255; ++code)
        if (std::abs(relative_luminance(eotf, code) - luminance) <
            std::abs(relative_luminance(eotf, nearest) - luminance))
            nearest = code;
    return nearest;
}

double luminance_of_lightness(double lightness) {
    // 8 = 116 cbrt(216/24389) - 16, where the straight part near black ends.
    return lightness > 8 ? std::pow((lightness + 16) / 116, 3) : lightness * 27 / 24389;
}

std::optional<Surround> surround_of(const std::string& definition, const Eotf& eotf) {
    const auto colon = definition.find(':');
    if (colon == std::string::npos)
        return std::nullopt;
    const auto kind = definition.substr(0, colon);
    const auto value = number_in(definition.substr(colon + 1));
    const auto within = [&](double high) { return value && *value >= 0 && *value <= high; };
    if (kind == "code" && within(255) && *value == std::floor(*value))
        return Surround{static_cast<int>(*value), definition};
    if (kind == "lstar" && within(100))
        return Surround{nearest_code(eotf, luminance_of_lightness(*value)), definition};
    if (kind == "linear" && within(1))
        return Surround{nearest_code(eotf, *value), definition};
    return std::nullopt;
}

std::string text_of(const Room& room) {
    std::string text;
    const auto add = [&](std::string_view name, const std::string& value) {
        text += fmt::format("{}{}={}", text.empty() ? "" : "; ", name, value);
    };
    const auto add_figure = [&](std::string_view name, std::optional<double> value) {
        if (value)
            add(name, fmt::format("{}", *value));
    };
    add_figure("peak_cd_m2", room.peak_cd_m2);
    add_figure("black_ratio", room.black_ratio);
    add_figure("screen_off_ratio", room.screen_off_ratio);
    add_figure("background_ratio", room.background_ratio);
    add_figure("ambient_lux", room.ambient_lux);
    add_figure("max_angle_deg", room.max_angle_deg);
    if (!room.background_white.empty())
        add("background_white", room.background_white);
    return text;
}

double pixels_per_degree(double distance_mm, double pixel_pitch_mm) {
    EXPECTS(distance_mm > 0 && pixel_pitch_mm > 0);
    return std::numbers::pi / 180 * distance_mm / pixel_pitch_mm;
}

} // namespace protocols
