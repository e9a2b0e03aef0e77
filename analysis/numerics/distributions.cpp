// Boost.Math's incomplete beta and gamma, carried in long double: its wider exponent reaches
// 1e-4932, its wider mantissa absorbs the rounding of the arguments (a relative 1e-16 in x is 1e-12
// in a tail with 18,000 degrees of freedom).  Below that, the leading term times its series, in
// logs.
#include "analysis/numerics/distributions.h"

#include "protocols/contract.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace analysis::numerics {
namespace {

namespace bm = boost::math;
using Real = long double;

// Underflow to zero is an answer here; the logarithm is found another way.
using Quiet = bm::policies::policy<bm::policies::underflow_error<bm::policies::ignore_error>,
                                   bm::policies::denorm_error<bm::policies::ignore_error>,
                                   bm::policies::overflow_error<bm::policies::ignore_error>,
                                   bm::policies::promote_double<false>>;
constexpr Quiet quiet{};

constexpr Real ln10 = std::numbers::ln10_v<Real>;
constexpr Real smallest_trusted = 1e-4900L; // above the subnormals of the 80-bit format

struct Split { // lower + upper = 1, each with its own digits; logarithms where they underflow
    Real lower = 0, upper = 0;
    Real log_lower = 0, log_upper = 0;
};

Real log_of(Real p, Real other) {
    return p > 0.5L ? std::log1p(-other) : std::log(p);
}

Split split(Real lower, Real upper) {
    return {lower, upper, log_of(lower, upper), log_of(upper, lower)};
}

Tail upper_of(const Split& s) {
    return {static_cast<double>(s.upper), static_cast<double>(s.log_upper / ln10)};
}

Tail lower_of(const Split& s) {
    return {static_cast<double>(s.lower), static_cast<double>(s.log_lower / ln10)};
}

Tail undefined() {
    return {std::nan(""), std::nan("")};
}

// ln I_x(a, b) where it underflows, from the first term and 2F1(a + b, 1; a + 1; x); y = 1 - x.
Real log_incomplete_beta(Real a, Real b, Real x, Real y) {
    Real term = 1, sum = 1;
    for (Real n = 0; term > sum * std::numeric_limits<Real>::epsilon(); ++n) {
        term *= x * (a + b + n) / (a + 1 + n);
        sum += term;
    }
    const Real log_beta = bm::lgamma(a, quiet) + bm::lgamma(b, quiet) - bm::lgamma(a + b, quiet);
    return a * std::log(x) + b * std::log(y) - std::log(a) - log_beta + std::log(sum);
}

// ln Q(a, x) where it underflows (x far above a): the continued fraction by modified Lentz.
Real log_gamma_q(Real a, Real x) {
    Real b = x + 1 - a, d = 1 / b, c = 1 / smallest_trusted, fraction = d;
    for (Real n = 1;; ++n) {
        const Real an = -n * (n - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        fraction *= d * c;
        if (std::abs(d * c - 1) <= std::numeric_limits<Real>::epsilon())
            break;
    }
    return a * std::log(x) - x - bm::lgamma(a, quiet) + std::log(fraction);
}

// I_x(a, b) and its complement, y = 1 - x.  The beta at the smaller argument is the accurate one;
// Boost 1.74's own complement of a small one is wrong by 2e-12 at (1/2, 1/2, 1e-16).
Split beta_split(Real a, Real b, Real x, Real y) {
    const Real at_smaller = x <= y ? bm::ibeta(a, b, x, quiet) : bm::ibeta(b, a, y, quiet);
    const auto complement = [&] {
        if (at_smaller <= 0.5L)
            return 1 - at_smaller;
        return x <= y ? bm::ibetac(a, b, x, quiet) : bm::ibetac(b, a, y, quiet);
    };
    Split s = x <= y ? split(at_smaller, complement()) : split(complement(), at_smaller);
    if (s.upper < smallest_trusted && y > 0)
        s.log_upper = log_incomplete_beta(b, a, y, x);
    if (s.lower < smallest_trusted && x > 0)
        s.log_lower = log_incomplete_beta(a, b, x, y);
    return s;
}

Split chi_squared_split(Real x, Real df) {
    if (x <= 0)
        return split(0, 1);
    if (std::isinf(x))
        return split(1, 0);
    Split s = split(bm::gamma_p(df / 2, x / 2, quiet), bm::gamma_q(df / 2, x / 2, quiet));
    if (s.upper < smallest_trusted)
        s.log_upper = log_gamma_q(df / 2, x / 2);
    return s;
}

Split f_split(Real f, Real df1, Real df2) {
    if (std::isinf(df2))
        return chi_squared_split(df1 * f, df1);
    if (f <= 0)
        return split(0, 1);
    if (std::isinf(f))
        return split(1, 0);
    const Real scaled = df1 * f, whole = df2 + scaled;
    return beta_split(df1 / 2, df2 / 2, scaled / whole, df2 / whole);
}

// erfc(z / sqrt2) e^(z^2 / 2) for large z: Laplace's continued fraction from the tail end.
Real scaled_normal_tail(Real z) {
    Real fraction = z;
    for (int n = 60; n > 0; --n)
        fraction = z + static_cast<Real>(n) / fraction;
    return std::sqrt(2 / std::numbers::pi_v<Real>) / fraction;
}

constexpr double continued_fraction_from = 12; // 60 terms are exact to long double there

Real normal_upper(Real z) {
    return std::erfc(z / std::numbers::sqrt2_v<Real>) / 2;
}

Real log_normal_upper(Real z) {
    if (z < continued_fraction_from)
        return log_of(normal_upper(z), normal_upper(-z));
    return -z * z / 2 + std::log(scaled_normal_tail(z) / 2);
}

} // namespace

Tail f_upper_tail(double f, double df1, double df2) {
    EXPECTS(df1 > 0 && std::isfinite(df1) && df2 > 0);
    return std::isnan(f) ? undefined() : upper_of(f_split(f, df1, df2));
}

Tail f_lower_tail(double f, double df1, double df2) {
    EXPECTS(df1 > 0 && std::isfinite(df1) && df2 > 0);
    return std::isnan(f) ? undefined() : lower_of(f_split(f, df1, df2));
}

Tail t_two_sided(double t, double df) {
    EXPECTS(df > 0);
    return std::isnan(t) ? undefined() : upper_of(f_split(static_cast<Real>(t) * t, 1, df));
}

Tail t_upper_tail(double t, double df) {
    EXPECTS(df > 0);
    if (std::isnan(t))
        return undefined();
    const Split s = f_split(static_cast<Real>(t) * t, 1, df);
    constexpr Real log_half = -std::numbers::ln2_v<Real>;
    const Split half{0.5L + s.lower / 2, s.upper / 2, std::log1p(-s.upper / 2),
                     log_half + s.log_upper};
    return t >= 0 ? upper_of(half) : lower_of(half);
}

Tail chi_squared_upper_tail(double x, double df) {
    EXPECTS(df > 0 && std::isfinite(df));
    return std::isnan(x) ? undefined() : upper_of(chi_squared_split(x, df));
}

Tail chi_squared_lower_tail(double x, double df) {
    EXPECTS(df > 0 && std::isfinite(df));
    return std::isnan(x) ? undefined() : lower_of(chi_squared_split(x, df));
}

Tail normal_upper_tail(double z) {
    return {static_cast<double>(normal_upper(z)), static_cast<double>(log_normal_upper(z) / ln10)};
}

double log_normal_cdf(double z) {
    return static_cast<double>(log_normal_upper(-static_cast<Real>(z)));
}

double normal_pdf_over_cdf(double z) {
    if (-z >= continued_fraction_from)
        return static_cast<double>(std::sqrt(2 / std::numbers::pi_v<Real>) /
                                   scaled_normal_tail(-static_cast<Real>(z)));
    const Real x = z;
    return static_cast<double>(std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi_v<Real>) /
                               normal_upper(-x));
}

double normal_quantile(double p) {
    EXPECTS(p > 0 && p < 1);
    return -std::numbers::sqrt2 * bm::erfc_inv(2 * p, quiet);
}

double t_quantile_two_sided(double p, double df) {
    EXPECTS(p > 0 && p <= 1 && df > 0);
    if (std::isinf(df))
        return p == 1 ? 0.0 : -normal_quantile(p / 2);
    return bm::quantile(bm::complement(bm::students_t_distribution<double, Quiet>(df), p / 2));
}

double f_quantile_upper(double p, double df1, double df2) {
    EXPECTS(p > 0 && p < 1 && df1 > 0 && std::isfinite(df1) && df2 > 0);
    if (std::isinf(df2))
        return chi_squared_quantile_upper(p, df1) / df1;
    return bm::quantile(bm::complement(bm::fisher_f_distribution<double, Quiet>(df1, df2), p));
}

double chi_squared_quantile_upper(double p, double df) {
    EXPECTS(p > 0 && p < 1 && df > 0 && std::isfinite(df));
    return bm::quantile(bm::complement(bm::chi_squared_distribution<double, Quiet>(df), p));
}

namespace {

// Both tails of the mixture: Poisson(lambda / 2) weights, df1 + 2j over the same scaled statistic.
Split noncentral_f_split(Real f, Real df1, Real df2, Real lambda) {
    if (f <= 0)
        return split(0, 1);
    if (std::isinf(f))
        return split(1, 0);
    const Real scaled = df1 * f, whole = df2 + scaled, half = lambda / 2;
    Real lower = 0, upper = 0;
    const auto add = [&](Real j, Real weight) {
        const Split term = beta_split(df1 / 2 + j, df2 / 2, scaled / whole, df2 / whole);
        lower += weight * term.lower;
        upper += weight * term.upper;
        return weight * term.lower > lower * 1e-20L || weight * term.upper > upper * 1e-20L;
    };
    const Real mode = std::floor(half);
    const Real top =
        lambda == 0 ? 1 : std::exp(mode * std::log(half) - half - bm::lgamma(mode + 1, quiet));
    Real weight = top;
    for (Real j = mode; add(j, weight); ++j)
        weight *= half / (j + 1);
    weight = top;
    for (Real j = mode; j > 0;) {
        weight *= j / half;
        if (!add(--j, weight))
            break;
    }
    return split(lower, upper);
}

} // namespace

Tail noncentral_f_upper_tail(double f, double df1, double df2, double lambda) {
    EXPECTS(df1 > 0 && std::isfinite(df1) && df2 > 0 && std::isfinite(df2));
    EXPECTS(lambda >= 0 && std::isfinite(lambda));
    return std::isnan(f) ? undefined() : upper_of(noncentral_f_split(f, df1, df2, lambda));
}

Tail noncentral_f_lower_tail(double f, double df1, double df2, double lambda) {
    EXPECTS(df1 > 0 && std::isfinite(df1) && df2 > 0 && std::isfinite(df2));
    EXPECTS(lambda >= 0 && std::isfinite(lambda));
    return std::isnan(f) ? undefined() : lower_of(noncentral_f_split(f, df1, df2, lambda));
}

} // namespace analysis::numerics
