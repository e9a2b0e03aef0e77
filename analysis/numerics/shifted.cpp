#include "analysis/numerics/shifted.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace analysis::numerics {
namespace {

using Real = long double;

// A negative power divides, which rounds once as long as the power is exact (up to 10^27).
Real times_power_of_ten(Real value, int exponent) {
    const Real power = std::pow(Real{10}, static_cast<Real>(std::abs(exponent)));
    return exponent < 0 ? value / power : value * power;
}

WideInteger magnitude(WideInteger x) {
    return x < 0 ? -x : x;
}

// In units of 10^unit; false when the integer would not fit.
bool rescale(Decimal value, int unit, WideInteger& out) {
    constexpr WideInteger limit = WideInteger{1} << 125;
    for (; value.mantissa != 0 && value.exponent > unit; --value.exponent) {
        if (magnitude(value.mantissa) > limit / 10)
            return false;
        value.mantissa *= 10;
    }
    out = value.mantissa;
    return magnitude(out) <= limit;
}

} // namespace

double Shifted::in_data_unit(long double residue, long double from) const {
    return static_cast<double>(times_power_of_ten(from + residue, exponent));
}

double Shifted::squares_in_data_unit(long double squares) const {
    return static_cast<double>(times_power_of_ten(squares, 2 * exponent));
}

Shifted about_first(std::span<const Decimal> values) {
    int unit = std::numeric_limits<int>::max(), largest = std::numeric_limits<int>::min();
    for (const auto& value : values)
        if (value.mantissa != 0) {
            unit = std::min(unit, value.exponent);
            largest = std::max(largest, value.exponent);
        }
    if (largest < unit)
        unit = largest = 0; // nothing but zeros
    Shifted result;
    std::vector<WideInteger> integers(values.size());
    bool fits = true;
    for (std::size_t i = 0; i < values.size() && fits; ++i)
        fits = rescale(values[i], unit, integers[i]);
    if (fits && !values.empty()) {
        result.exponent = unit;
        result.origin = static_cast<Real>(integers[0]);
        for (const auto integer : integers)
            result.residues.push_back(static_cast<Real>(integer - integers[0]));
        return result;
    }
    result.exponent = largest;
    for (const auto& value : values)
        result.residues.push_back(
            times_power_of_ten(static_cast<Real>(value.mantissa), value.exponent - largest));
    return result;
}

} // namespace analysis::numerics
