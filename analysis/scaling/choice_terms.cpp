// Each slope is written twice: as (a - b)/2 - (a + b)(P - 1/2), which keeps its digits near
// equality, and as a(1 - P) - bP, which keeps them where P is near 0 or 1.
#include "analysis/scaling/choice_terms.h"

#include "analysis/numerics/distributions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace analysis::scaling {
namespace {

constexpr double inv_sqrt2 = std::numbers::sqrt2 / 2;
constexpr double inv_sqrt_2pi = 0.3989422804014327; // 1 / sqrt(2 pi)
constexpr double near_equality = 1;
constexpr double far_out = 8;

// 0 ln 0 = 0: nobody voted so.
double times_log(double votes, double log_p) {
    return votes == 0 ? 0 : votes * log_p;
}

// Far out the rounding of d / sqrt2 costs d^2 ulp of a tail, and q - d cancels as much again: the
// ratios of density and tail have functions of their own, which are slower.
PairTerm far_probit_term(double d, double a, double b) {
    const double r = numerics::normal_pdf_over_cdf(d), q = numerics::normal_pdf_over_cdf(-d);
    return {times_log(a, numerics::log_normal_cdf(d)) + times_log(b, numerics::log_normal_cdf(-d)),
            a * r - b * q, a * r * (d + r) + b * q * (q - d)};
}

} // namespace

PairTerm logit_term(double d, double a, double b) {
    const bool near = std::abs(d) < near_equality;
    const double gap = near ? std::expm1(-std::abs(d)) : 0; // e^-|d| - 1
    const double e = near ? 1 + gap : std::exp(-std::abs(d));
    const double large = 1 / (1 + e), small = e * large;
    const double log_large = -std::log1p(e), log_small = log_large - std::abs(d);
    const double p = d >= 0 ? large : small, q = d >= 0 ? small : large;
    const double slope =
        near ? (a - b) / 2 - (a + b) / 2 * std::copysign(-gap * large, d) : a * q - b * p;
    const double log_likelihood = d >= 0 ? times_log(a, log_large) + times_log(b, log_small)
                                         : times_log(a, log_small) + times_log(b, log_large);
    return {log_likelihood, slope, (a + b) * p * q};
}

PairTerm probit_term(double d, double a, double b) {
    if (std::abs(d) > far_out)
        return far_probit_term(d, a, b);
    const double density = inv_sqrt_2pi * std::exp(-d * d / 2);
    const double small = std::erfc(std::abs(d) * inv_sqrt2) / 2, large = 1 - small;
    const double p = d >= 0 ? large : small, q = d >= 0 ? small : large;
    const double log_small = std::log(small), log_large = std::log1p(-small);
    const double slope = std::abs(d) < near_equality
                             ? density * ((a - b) - (a + b) * std::erf(d * inv_sqrt2)) / 2 / (p * q)
                             : a * (density / p) - b * (density / q);
    const double r = density / p, s = density / q;
    const double log_likelihood = d >= 0 ? times_log(a, log_large) + times_log(b, log_small)
                                         : times_log(a, log_small) + times_log(b, log_large);
    return {log_likelihood, slope, a * r * (d + r) + b * s * (s - d)};
}

TiedPairTerm davidson_term(double d, double log_nu, double a, double b, double ties) {
    const double largest = std::max(std::abs(d) / 2, log_nu);
    double first = std::exp(d / 2 - largest), second = std::exp(-d / 2 - largest);
    double tie = std::exp(log_nu - largest);
    const double sum = first + second + tie, n = a + b + ties;
    first /= sum;
    second /= sum;
    tie /= sum;
    const double gap = first - second, decided = first + second;
    TiedPairTerm term;
    term.log_likelihood = (a - b) * d / 2 + ties * log_nu - n * (largest + std::log(sum));
    term.slope = (a - b) / 2 - n * gap / 2;
    term.slope_nu = ties - n * tie;
    term.curvature = n * (decided - gap * gap) / 4;
    term.curvature_cross = -n * gap * tie / 2;
    term.curvature_nu = n * tie * decided;
    return term;
}

double choice_probability(Link link, double d) {
    if (link == Link::Probit)
        return std::erfc(-d * inv_sqrt2) / 2;
    const double e = std::exp(-std::abs(d));
    return d >= 0 ? 1 / (1 + e) : e / (1 + e);
}

} // namespace analysis::scaling
