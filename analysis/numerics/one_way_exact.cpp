// Every value is an integer times a common power of ten (or of two, for doubles).
#include "analysis/numerics/one_way_exact.h"

#include "protocols/contract.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace analysis::numerics {
namespace {

using Real = long double;

struct Scaled { // mantissa times base^exponent
    WideInteger mantissa = 0;
    int exponent = 0;
};

Scaled scaled(Decimal value) {
    return {value.mantissa, value.exponent};
}

Scaled scaled(double value) {
    EXPECTS(std::isfinite(value));
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    if (mantissa == 0)
        return {};
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    return {mantissa / (std::int64_t{1} << zeros), exponent - 53 + zeros};
}

// sum * base^exponent; a negative power divides, which rounds once as long as base^|exponent| is
// exact (up to 10^27).
Real times_power(Real sum, int base, int exponent) {
    const Real power = std::pow(static_cast<Real>(base), static_cast<Real>(std::abs(exponent)));
    return exponent < 0 ? sum / power : sum * power;
}

// Sums in the common unit, before anything is rounded to double.
struct UnitSums {
    std::vector<Real> mean; // of the shifted values
    Real between = 0, within = 0;
};

struct GroupSum {
    std::int64_t n = 0;
    WideInteger sum = 0, squares = 0;
};

WideInteger square(WideInteger x) {
    return x * x;
}

Real real(WideInteger x) {
    return static_cast<Real>(x);
}

// within = Sum (n Q - S^2) / n and between = Sum (N S_i - n_i S)^2 / (n_i N^2): integers but for
// the divisions, and sums of terms of one sign.
UnitSums integer_sums(const std::vector<std::vector<WideInteger>>& groups) {
    std::vector<GroupSum> sums;
    GroupSum all;
    for (const auto& group : groups) {
        auto& g = sums.emplace_back();
        g.n = static_cast<std::int64_t>(group.size());
        for (const WideInteger value : group) {
            g.sum += value;
            g.squares += square(value);
        }
        all.n += g.n;
        all.sum += g.sum;
    }
    UnitSums result;
    const Real total = real(all.n);
    for (const GroupSum& g : sums) {
        const Real n = real(g.n);
        result.mean.push_back(real(g.sum) / n);
        result.within += real(g.n * g.squares - square(g.sum)) / n;
        const Real apart = real(all.n * g.sum - g.n * all.sum) / total;
        result.between += apart * apart / n;
    }
    return result;
}

Real compensated_mean(const std::vector<Real>& values) {
    Real sum = 0, lost = 0;
    for (const Real value : values) {
        const Real next = sum + value;
        lost += std::abs(sum) >= std::abs(value) ? (sum - next) + value : (value - next) + sum;
        sum = next;
    }
    return (sum + lost) / real(static_cast<std::int64_t>(values.size()));
}

UnitSums real_sums(const std::vector<std::vector<Real>>& groups) {
    UnitSums result;
    std::vector<Real> all;
    for (const auto& group : groups)
        all.insert(all.end(), group.begin(), group.end());
    const Real grand = compensated_mean(all);
    for (const auto& group : groups) {
        const Real mean = compensated_mean(group),
                   n = real(static_cast<std::int64_t>(group.size()));
        Real squares = 0, rest = 0;
        for (const Real value : group) {
            squares += (value - mean) * (value - mean);
            rest += value - mean;
        }
        const bool constant =
            std::all_of(group.begin(), group.end(), [&](Real value) { return value == group[0]; });
        result.mean.push_back(mean);
        result.within += constant ? 0 : squares - rest * rest / n;
        result.between += n * (mean - grand) * (mean - grand);
    }
    return result;
}

int bits_of(WideInteger magnitude) {
    int bits = 0;
    for (; magnitude > 0; magnitude >>= 1)
        ++bits;
    return bits;
}

WideInteger magnitude(WideInteger x) {
    return x < 0 ? -x : x;
}

// The values in units of base^unit, or nothing when some need more than 126 bits for that.
std::vector<std::vector<WideInteger>>
in_common_unit(const std::vector<std::vector<Scaled>>& groups, int base, int unit) {
    constexpr WideInteger limit = WideInteger{1} << 125;
    std::vector<std::vector<WideInteger>> result;
    for (const auto& group : groups) {
        auto& out = result.emplace_back();
        for (auto [mantissa, exponent] : group) {
            for (; mantissa != 0 && exponent > unit; --exponent) {
                if (magnitude(mantissa) > limit / base)
                    return {};
                mantissa *= base;
            }
            if (magnitude(mantissa) > limit)
                return {};
            out.push_back(mantissa);
        }
    }
    return result;
}

std::vector<std::vector<Real>>
as_reals(const std::vector<std::vector<Scaled>>& groups, int base, int unit) {
    std::vector<std::vector<Real>> result;
    for (const auto& group : groups) {
        auto& out = result.emplace_back();
        for (const auto& [mantissa, exponent] : group)
            out.push_back(mantissa == 0 ? 0 : times_power(real(mantissa), base, exponent - unit));
    }
    return result;
}

struct Located { // sums in units of base^unit about `shift`
    UnitSums sums;
    Real shift = 0;
    int unit = 0;
};

// 64-bit mantissas: the shift is exact when the integers fit, and not needed when they do not, for
// then the data span more than 38 digits.
Located sums_of(const std::vector<std::vector<Scaled>>& groups, int base, std::int64_t values) {
    int unit = std::numeric_limits<int>::max(), largest = std::numeric_limits<int>::min();
    for (const auto& group : groups)
        for (const auto& [mantissa, exponent] : group)
            if (mantissa != 0) {
                unit = std::min(unit, exponent);
                largest = std::max(largest, exponent);
            }
    if (largest < unit)
        unit = largest = 0; // nothing but zeros
    auto integers = in_common_unit(groups, base, unit);
    if (integers.empty())
        return {real_sums(as_reals(groups, base, largest)), 0, largest};
    const WideInteger shift = integers[0][0];
    WideInteger widest = 0;
    for (auto& group : integers)
        for (auto& value : group) {
            value -= shift;
            widest = std::max(widest, magnitude(value));
        }
    if (2 * (bits_of(widest) + bits_of(values)) <= 126)
        return {integer_sums(integers), real(shift), unit};
    std::vector<std::vector<Real>> reals;
    for (const auto& group : integers)
        reals.emplace_back(group.begin(), group.end());
    return {real_sums(reals), real(shift), unit};
}

OneWaySums table(const std::vector<std::vector<Scaled>>& groups, int base) {
    EXPECTS(groups.size() >= 2);
    OneWaySums result;
    for (const auto& group : groups) {
        EXPECTS(!group.empty());
        result.values += static_cast<std::int64_t>(group.size());
    }
    result.df_between = static_cast<double>(groups.size() - 1);
    result.df_within = static_cast<double>(result.values) - static_cast<double>(groups.size());
    EXPECTS(result.df_within > 0);

    const Located located = sums_of(groups, base, result.values);
    const auto& [mean, between, within] = located.sums;
    for (const Real value : mean)
        result.mean.push_back(
            static_cast<double>(times_power(located.shift + value, base, located.unit)));
    const auto in_unit = [&](Real sum) {
        return static_cast<double>(times_power(sum, base, 2 * located.unit));
    };
    result.ss_between = in_unit(between);
    result.ss_within = in_unit(within);
    result.ms_between = in_unit(between / result.df_between);
    result.ms_within = in_unit(within / result.df_within);
    result.f = static_cast<double>((between / result.df_between) / (within / result.df_within));
    result.r_squared = static_cast<double>(between / (between + within));
    result.residual_sd =
        static_cast<double>(times_power(std::sqrt(within / result.df_within), base, located.unit));
    result.p = f_upper_tail(result.f, result.df_between, result.df_within);
    return result;
}

template <class Value>
std::vector<std::vector<Scaled>> scaled_groups(std::span<const std::vector<Value>> groups) {
    std::vector<std::vector<Scaled>> result;
    for (const auto& group : groups) {
        auto& out = result.emplace_back();
        for (const auto& value : group)
            out.push_back(scaled(value));
    }
    return result;
}

} // namespace

OneWaySums one_way_exact(std::span<const std::vector<Decimal>> groups) {
    return table(scaled_groups(groups), 10);
}

OneWaySums one_way_exact(std::span<const std::vector<double>> groups) {
    return table(scaled_groups(groups), 2);
}

} // namespace analysis::numerics
