// Formatting of numbers for people.
#include "experiment/report/numbers.h"

#include <fmt/format.h>

#include <cmath>

namespace experiment::report {

namespace {

std::string with_minus(std::string text) {
    if (!text.empty() && text.front() == '-')
        text.replace(0, 1, "\u2212");
    return text;
}

std::string superscript(int exponent) {
    static constexpr const char* digits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                             "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string raised = exponent < 0 ? "\u207b" : "";
    for (const char digit : std::to_string(std::abs(exponent)))
        raised += digits[digit - '0'];
    return raised;
}

// The mantissa is rounded by the formatting itself, so that 9.96 becomes 1.0 of the next power.
std::string scientific(double value, int digits) {
    const std::string text = fmt::format("{:.{}e}", value, digits - 1);
    const auto e = text.find('e');
    return with_minus(text.substr(0, e)) + "\u00a0\u00d7\u00a010" +
           superscript(std::stoi(text.substr(e + 1)));
}

// p = 10^log10_p where that is no double any more.
std::string scientific_from_log10(double log10_p, int digits) {
    double power = std::floor(log10_p);
    double mantissa = std::pow(10.0, log10_p - power);
    if (fmt::format("{:.{}f}", mantissa, digits - 1) == fmt::format("{:.{}f}", 10.0, digits - 1)) {
        mantissa = 1;
        power += 1;
    }
    return fmt::format("{:.{}f}\u00a0\u00d7\u00a010{}", mantissa, digits - 1,
                       superscript(static_cast<int>(power)));
}

} // namespace

std::string decimal(double value, int decimals) {
    if (std::isnan(value))
        return no_number;
    if (std::isinf(value))
        return value > 0 ? "\u221e" : "\u2212\u221e";
    const std::string text = fmt::format("{:.{}f}", value, decimals);
    const bool zero = text.find_first_not_of("-0.") == std::string::npos;
    return with_minus(zero && text.front() == '-' ? text.substr(1) : text);
}

std::string significant(double value, int digits) {
    if (!std::isfinite(value))
        return decimal(value, 0);
    if (value == 0)
        return "0";
    const int power = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (power < -4 || power > 6)
        return scientific(value, digits);
    return decimal(value, std::max(0, digits - 1 - power));
}

std::string degrees(double df) {
    return decimal(df, df == std::floor(df) ? 0 : 2);
}

std::string p_value(double p, double log10_p) {
    if (std::isnan(p))
        return no_number;
    if (p >= 0.001)
        return decimal(p, 3);
    if (p >= 1e-300)
        return scientific(p, 2);
    return std::isfinite(log10_p) ? scientific_from_log10(log10_p, 2) : "0";
}

std::string p_value(double p) {
    return p_value(p, std::log10(p));
}

std::string p_equals(double p, double log10_p) {
    return "p\u00a0=\u00a0" + p_value(p, log10_p);
}

std::string p_equals(double p) {
    return "p\u00a0=\u00a0" + p_value(p);
}

std::string percent(double share) {
    return std::isnan(share) ? no_number : decimal(100 * share, 0) + "\u00a0%";
}

std::string votes(double count) {
    return decimal(count, count == std::floor(count) ? 0 : 1);
}

std::string grouped(long long count) {
    std::string text = std::to_string(count);
    const std::ptrdiff_t first = text.front() == '-' ? 1 : 0;
    for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > first; at -= 3)
        text.insert(static_cast<std::size_t>(at), "\u202f");
    return with_minus(text);
}

} // namespace experiment::report
