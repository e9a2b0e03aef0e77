// Measured greys.
#include "protocols/calibration.h"

#include "protocols/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace protocols {

namespace {

std::string_view trimmed(std::string_view text) {
    constexpr auto blank = " \t\r";
    const auto first = text.find_first_not_of(blank);
    return first == std::string_view::npos
               ? std::string_view()
               : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    while (true) {
        const auto comma = line.find(',');
        fields.push_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos)
            return fields;
        line.remove_prefix(comma + 1);
    }
}

double number_in(std::string_view text) {
    double number = 0;
    const auto* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    return error == std::errc() && end == last ? number : std::numeric_limits<double>::quiet_NaN();
}

bool is_code(double value) {
    return value >= 0 && value <= 255 && value == std::floor(value);
}

// A line's grey; empty for a colour, an error for what cannot be read.
Expected<std::optional<GreyStep>> step_of(const std::vector<std::string_view>& fields, bool xyz) {
    if (fields.size() != (xyz ? 6U : 2U))
        return tl::unexpected(fmt::format("{} columns, expected {}", fields.size(), xyz ? 6 : 2));
    for (std::size_t i = 0; i < (xyz ? 3U : 1U); ++i)
        if (!is_code(number_in(fields[i])))
            return tl::unexpected(
                fmt::format("\"{}\", expected a code value of 0 to 255", fields[i]));
    const auto light = number_in(fields[xyz ? 4 : 1]);
    if (!(light >= 0 && light <= 100000))
        return tl::unexpected(
            fmt::format("\"{}\", expected a luminance in cd/m2", fields[xyz ? 4 : 1]));
    if (xyz && (fields[0] != fields[1] || fields[1] != fields[2]))
        return std::optional<GreyStep>();
    return GreyStep{static_cast<int>(number_in(fields[0])), light};
}

Expected<std::vector<GreyStep>> checked(std::vector<GreyStep> steps, std::string_view file) {
    const auto refuse = [&](const std::string& what) {
        return tl::unexpected(fmt::format("{}: {}", file, what));
    };
    std::sort(steps.begin(), steps.end(),
              [](const auto& a, const auto& b) { return a.code < b.code; });
    if (steps.size() < 9)
        return refuse(fmt::format("{} greys, expected at least 9", steps.size()));
    if (steps.front().code != 0 || steps.back().code != 255)
        return refuse("no measurement of code 0 or of code 255, expected both");
    for (std::size_t i = 1; i < steps.size(); ++i) {
        if (steps[i].code == steps[i - 1].code)
            return refuse(fmt::format("code {} comes twice, expected once", steps[i].code));
        if (!(steps[i].cd_m2 > steps[i - 1].cd_m2))
            return refuse(fmt::format("code {} is not lighter than code {} ({} and {} cd/m2); "
                                      "expected light that rises with the code",
                                      steps[i].code, steps[i - 1].code, steps[i].cd_m2,
                                      steps[i - 1].cd_m2));
    }
    return steps;
}

double modelled(const GammaFit& fit, int code) {
    return fit.black_cd_m2 +
           (fit.white_cd_m2 - fit.black_cd_m2) * std::pow(code / 255.0, fit.gamma);
}

double squared_residuals(GammaFit fit, double gamma, const std::vector<GreyStep>& steps) {
    fit.gamma = gamma;
    double sum = 0;
    for (const auto& step : steps)
        sum += std::pow(step.cd_m2 - modelled(fit, step.code), 2);
    return sum;
}

} // namespace

const std::vector<int>& photometer_codes() {
    static const std::vector<int> codes{0, 32, 64, 96, 128, 160, 192, 224, 255};
    return codes;
}

Expected<std::vector<GreyStep>> parse_photometer(std::string_view text, std::string_view file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // of spreadsheets
    if (text.starts_with(byte_order_mark))
        text.remove_prefix(byte_order_mark.size());
    std::vector<GreyStep> steps;
    std::optional<bool> xyz;
    for (int number = 1; !text.empty(); ++number) {
        const auto line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        if (line.find('\0') != line.npos)
            return tl::unexpected(
                fmt::format("{}:{}: a zero byte; save the file as text", file, number));
        if (trimmed(line).empty() || trimmed(line).starts_with("#"))
            continue;
        if (!xyz) {
            xyz = trimmed(line) == "code_r,code_g,code_b,X,Y,Z";
            if (!*xyz && trimmed(line) != "code,cd_m2")
                return tl::unexpected(fmt::format("{}:{}: columns \"{}\", expected \"code,cd_m2\" "
                                                  "or \"code_r,code_g,code_b,X,Y,Z\"",
                                                  file, number, trimmed(line)));
            continue;
        }
        const auto step = step_of(fields_of(line), *xyz);
        if (!step)
            return tl::unexpected(fmt::format("{}:{}: {}", file, number, step.error()));
        if (*step)
            steps.push_back(**step);
    }
    return checked(std::move(steps), file);
}

GammaFit fit_gamma(const std::vector<GreyStep>& steps) {
    EXPECTS(steps.size() >= 9);
    GammaFit fit{steps.front().cd_m2, steps.back().cd_m2, 0, 0};
    // Golden section: the sum of squares has one valley in gamma for light that rises.
    constexpr double golden = 0.6180339887498949; // (sqrt 5 - 1) / 2
    double low = 0.5, high = 5;
    while (high - low > 1e-6) {
        const double left = high - golden * (high - low);
        const double right = low + golden * (high - low);
        (squared_residuals(fit, left, steps) < squared_residuals(fit, right, steps) ? high : low) =
            squared_residuals(fit, left, steps) < squared_residuals(fit, right, steps) ? right
                                                                                       : left;
    }
    fit.gamma = (low + high) / 2;
    for (const auto& step : steps)
        fit.worst_residual = std::max(
            fit.worst_residual, std::abs(step.cd_m2 - modelled(fit, step.code)) / fit.white_cd_m2);
    return fit;
}

} // namespace protocols
