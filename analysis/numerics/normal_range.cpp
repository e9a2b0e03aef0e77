// With n = k - 1, Phi and Q the normal tails and w the range:
//   P(range > w) = k Int phi(z) { Q(z)^n - (Q(z) - Q(z + w))^n } dz
//   P(range < w) = k Int phi(z) (Phi(z + w) - Phi(z))^n dz
// Every integrand is smooth and falls off fast, so trapezoids converge geometrically; no sum has a
// term of the other sign, so small tails keep their digits.
#include "analysis/numerics/normal_range.h"

#include "analysis/numerics/distributions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace analysis::numerics {
namespace {

using Real = long double; // exponents of some hundreds cost digits otherwise

constexpr double inv_sqrt2 = std::numbers::sqrt2 / 2;
constexpr double inv_sqrt2_rest = -4.833646656726457e-17;   // 1/sqrt2 minus its double
constexpr double inv_sqrt_2pi = 0.398942280401432677939946; // 1/sqrt(2 pi)
constexpr double negligible = 1e-17;
constexpr int quiet_terms = 4; // as many negligible terms in a row end a sum

// The largest w that the inner quadrature sees.  Beyond, the chance that two pairs exceed w is
// exp(-w^2/12) = 1e-32 of that for one, and k (k - 1) Q(w / sqrt2), Bonferroni's bound, is exact.
constexpr double largest_inner_w = 30;

double density(double z) {
    return inv_sqrt_2pi * std::exp(-z * z / 2);
}

// Q(z + w + w_rest).  erfc multiplies a rounding of its argument by z^2, so what the sum and the
// product round away is given back to first order; Komatsu's bound on the slope is enough for that.
double normal_tail(double z, double w, double w_rest) {
    const double s = z + w;
    const double back = s - z;
    const double rest = (z - (s - back)) + (w - back) + w_rest;
    const double x = s * inv_sqrt2;
    const double tail = 0.5 * std::erfc(x);
    if (x < 1)
        return tail;
    const double dx = std::fma(s, inv_sqrt2, -x) + s * inv_sqrt2_rest + rest * inv_sqrt2;
    return tail * (1 - dx * (x + std::sqrt(x * x + 4 / std::numbers::pi)));
}

// a^n - (a - b)^n over a^n, with r = b / a: no cancellation.
double power_gap(double r, double n) {
    if (n > 12 || n != std::floor(n))
        return r < 1 ? -std::expm1(n * std::log1p(-r)) : 1.0;
    const double s = 1 - r;
    double sum = 1;
    for (double i = 1; i < n; ++i)
        sum = 1 + s * sum;
    return r * sum;
}

// Sums term(j) from `start` in both directions until the terms stay negligible.
template <class Term>
double sum_both_ways(int start, int first, int last, Term term) {
    double sum = 0;
    for (const int direction : {1, -1}) {
        int quiet = 0;
        for (int j = direction > 0 ? start : start - 1;
             j >= first && j <= last && quiet < quiet_terms; j += direction) {
            const double value = term(j);
            sum += value;
            quiet = value <= negligible * sum ? quiet + 1 : 0;
        }
    }
    return sum;
}

Real log_erfc(Real x) {
    return x < 100 ? std::log(std::erfc(x))
                   : log_normal_cdf(static_cast<double>(-x * std::numbers::sqrt2_v<Real>)) +
                         std::numbers::ln2_v<Real>;
}

// Phi(c + d) - Phi(c - d): 2 d phi(c) sum He_2n(c) d^2n / (2n + 1)!, where a difference of
// tails would cancel.
double short_normal_between(double c, double d) {
    double sum = 1, factor = 1, before = 1, hermite = c; // He_(2n-2), He_(2n-1)
    for (int m = 2, quiet = 0; quiet < 2; m += 2) {
        before = c * hermite - (m - 1) * before; // He_m
        hermite = c * before - m * hermite;      // He_(m+1)
        factor *= d * d / (m * (m + 1.0));
        sum += before * factor;
        quiet = std::abs(before * factor) <= negligible * sum ? quiet + 1 : 0;
    }
    return 2 * d * density(c) * sum;
}

// Phi(z + w) - Phi(z)
double normal_between(double z, double w) {
    if (w < 1)
        return short_normal_between(z + w / 2, w / 2);
    if (z >= 0)
        return normal_tail(z, 0, 0) - normal_tail(z, w, 0);
    if (z + w <= 0)
        return normal_tail(-z, -w, 0) - normal_tail(-z, 0, 0);
    return (std::erf(-z * inv_sqrt2) + std::erf((z + w) * inv_sqrt2)) / 2;
}

// Of the polynomials.  Width and degree were chosen by the error against the sums themselves, which
// 16 instead of 20 terms double.
constexpr Real piece_width = 0.25L;
constexpr std::size_t piece_terms = 20;

} // namespace

NormalRange::NormalRange(double k, double step_scale)
    : k_(k), n_(k - 1), upper_step_(step_scale * 0.61 / std::sqrt(k)),
      lower_step_(step_scale * 0.38 / std::sqrt(k)) {}

Real NormalRange::log_upper(Real w) {
    if (w > largest_inner_w)
        return std::log(static_cast<Real>(k_) * n_ / 2) + log_erfc(w / 2);
    return std::log(static_cast<Real>(upper(w)));
}

Real NormalRange::log_lower(Real w) {
    if (w > 9)
        return w > largest_inner_w ? -std::exp(log_upper(w))
                                   : std::log1p(-static_cast<Real>(upper(w)));
    return lower_log(static_cast<double>(w));
}

void NormalRange::lay_grid() {
    first_ = static_cast<int>(std::floor(-(largest_inner_w / 2 + 10) / upper_step_));
    const int last = static_cast<int>(std::ceil(12 / upper_step_));
    for (int j = first_; j <= last; ++j) {
        const double z = j * upper_step_, tail = normal_tail(z, 0, 0);
        grid_.push_back({z, density(z), tail, density(z) * std::pow(tail, n_)});
    }
}

double NormalRange::upper(Real w) {
    if (grid_.empty())
        lay_grid();
    const auto whole = static_cast<double>(w);
    const auto rest = static_cast<double>(w - static_cast<Real>(whole));
    const int start = static_cast<int>(std::lround(-whole / 2 / upper_step_));
    const int last = first_ + static_cast<int>(grid_.size()) - 1;
    const double sum = sum_both_ways(start, first_, last, [&](int j) {
        const Node& node = grid_[static_cast<std::size_t>(j - first_)];
        return node.weight * power_gap(normal_tail(node.z, whole, rest) / node.tail, n_);
    });
    return std::min(1.0, k_ * upper_step_ * sum);
}

Real NormalRange::lower_log(double w) const {
    const double h = lower_step_;
    const double largest = normal_between(-w / 2, w);
    const int reach = static_cast<int>(std::ceil(20 / h));
    const int start = static_cast<int>(std::lround(-w / 2 / h));
    const double sum = sum_both_ways(start, start - reach, start + reach, [&](int j) {
        const double z = j * h;
        return density(z) * std::pow(normal_between(z, w) / largest, n_);
    });
    return static_cast<Real>(n_) * std::log(static_cast<Real>(largest)) +
           std::log(static_cast<Real>(k_) * h * sum);
}

NormalRangePieces::NormalRangePieces(double k) : range_(k, 1.0) {}

Real NormalRangePieces::log_upper(Real w) {
    if (w >= largest_inner_w)
        return range_.log_upper(w);
    const auto place = static_cast<std::size_t>(w / piece_width);
    if (place >= pieces_.size())
        pieces_.resize(place + 1);
    auto& piece = pieces_[place];
    if (piece.empty())
        piece = made(place);
    const Real x = (w - (static_cast<Real>(place) + 0.5L) * piece_width) / (piece_width / 2);
    Real next = 0, after = 0; // Clenshaw's recurrence
    for (auto n = piece.size(); n-- > 1;)
        after = std::exchange(next, 2 * x * next - after + piece[n]);
    return std::log(x * next - after + piece[0]) - w * w / 4;
}

// Chebyshev's coefficients by his nodes.
std::vector<Real> NormalRangePieces::made(std::size_t place) {
    std::vector<Real> piece(piece_terms, 0);
    constexpr auto count = static_cast<Real>(piece_terms);
    for (std::size_t i = 0; i < piece_terms; ++i) {
        const Real angle = std::numbers::pi_v<Real> * (static_cast<Real>(i) + 0.5L) / count;
        const Real w = (static_cast<Real>(place) + 0.5L + std::cos(angle) / 2) * piece_width;
        const Real value = std::exp(range_.log_upper(w) + w * w / 4);
        for (std::size_t n = 0; n < piece_terms; ++n)
            piece[n] += (n == 0 ? 1 : 2) / count * value * std::cos(static_cast<Real>(n) * angle);
    }
    return piece;
}

} // namespace analysis::numerics
