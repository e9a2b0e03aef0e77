#include "analysis/anova/number_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace analysis::anova {

namespace {

// Values have up to 38 digits, so that differences of such as are near 10^-100 reach down to
// 10^-138, whose squares are doubles; and so are sums of 10^100 of the squares of 10^100.
constexpr int farthest_exponent = 100;

} // namespace

int unit_exponent(const Measurements& table) {
    int largest = std::numeric_limits<int>::min();
    for (const auto& [mantissa, exponent] : table.response)
        if (mantissa != 0) {
            const auto digits = std::log10(std::abs(static_cast<long double>(mantissa)));
            largest = std::max(largest, exponent + static_cast<int>(std::floor(digits)));
        }
    const bool nothing_but_zeros = largest == std::numeric_limits<int>::min();
    return nothing_but_zeros || std::abs(largest) <= farthest_exponent ? 0 : largest;
}

Measurements in_unit(Measurements table, int exponent) {
    for (auto& value : table.response)
        value.exponent -= value.mantissa == 0 ? 0 : exponent;
    return table;
}

std::string note_on_unit(const std::string& response, int exponent) {
    return fmt::format("Squares of {0} leave the range of a number, so everything here is of {0} / "
                       "1e{1}: means, differences and deviations want to be multiplied by 1e{1}, "
                       "sums and means of squares by 1e{2}; F, p and shares are those of {0}.",
                       response, exponent, 2 * exponent);
}

} // namespace analysis::anova
