// With n = k - 1, Phi and Q the normal tails and w the range of k standard normals:
//   P(range > w) = k Int phi(z) { Q(z)^n - (Q(z) - Q(z + w))^n } dz
//   P(range < w) = k Int phi(z) (Phi(z + w) - Phi(z))^n dz
// and for a standard deviation s = e^u with nu degrees of freedom
//   tail(q) = Int exp(c + nu (u - expm1(2u) / 2)) tail_infinite(q e^u) du.
// Every integrand is smooth and falls off fast, so trapezoids converge geometrically; no sum has a
// term of the other sign, so small tails keep their digits.  Steps were chosen by shortening: 10 %
// longer outer ones cost a digit, 18 % three.
#include "analysis/numerics/studentized_range.h"

#include "analysis/numerics/deviation_density.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace analysis::numerics {
namespace {

using Real = long double; // for the outer sum: its exponents of some hundreds cost digits otherwise

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

// Range of k normals with known deviation; the grids in z serve every w.
class InfiniteRange {
  public:
    InfiniteRange(double k, double step_scale)
        : k_(k), n_(k - 1), upper_step_(step_scale * 0.61 / std::sqrt(k)),
          lower_step_(step_scale * 0.38 / std::sqrt(k)) {}

    Real log_upper(Real w) {
        if (w > largest_inner_w)
            return std::log(static_cast<Real>(k_) * n_ / 2) + log_erfc(w / 2);
        return std::log(static_cast<Real>(upper(w)));
    }

    Real log_lower(Real w) {
        if (w > 9)
            return w > largest_inner_w ? -std::exp(log_upper(w))
                                       : std::log1p(-static_cast<Real>(upper(w)));
        return lower_log(static_cast<double>(w));
    }

  private:
    struct Node {
        double z, density, tail, weight; // weight = density Q(z)^n
    };

    static Real log_erfc(Real x) {
        return x < 100 ? std::log(std::erfc(x))
                       : log_normal_cdf(static_cast<double>(-x * std::numbers::sqrt2_v<Real>)) +
                             std::numbers::ln2_v<Real>;
    }

    void lay_grid() {
        first_ = static_cast<int>(std::floor(-(largest_inner_w / 2 + 10) / upper_step_));
        const int last = static_cast<int>(std::ceil(12 / upper_step_));
        for (int j = first_; j <= last; ++j) {
            const double z = j * upper_step_, tail = normal_tail(z, 0, 0);
            grid_.push_back({z, density(z), tail, density(z) * std::pow(tail, n_)});
        }
    }

    double upper(Real w) {
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

    // Phi(z + w) - Phi(z)
    static double normal_between(double z, double w) {
        if (w < 1)
            return short_normal_between(z + w / 2, w / 2);
        if (z >= 0)
            return normal_tail(z, 0, 0) - normal_tail(z, w, 0);
        if (z + w <= 0)
            return normal_tail(-z, -w, 0) - normal_tail(-z, 0, 0);
        return (std::erf(-z * inv_sqrt2) + std::erf((z + w) * inv_sqrt2)) / 2;
    }

    // The same about its middle c: 2 d phi(c) sum He_2n(c) d^2n / (2n + 1)!, where a difference of
    // tails would cancel.
    static double short_normal_between(double c, double d) {
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

    Real lower_log(double w) const {
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

    double k_, n_, upper_step_, lower_step_;
    int first_ = 0;
    std::vector<Node> grid_;
};

// The upper tail of such a range over exp(-w^2 / 4), by which it falls: an entire function that
// hardly changes, so short pieces of it are polynomials to the last bit.  A piece is made when it
// is first asked for.  Width and degree were chosen by the error against the sums themselves, which
// 16 instead of 20 terms double.
class RangePieces {
  public:
    explicit RangePieces(double k) : range_(k, 1.0) {}

    Real log_upper(Real w) {
        if (w >= largest_inner_w)
            return range_.log_upper(w);
        const auto place = static_cast<std::size_t>(w / width);
        if (place >= pieces_.size())
            pieces_.resize(place + 1);
        auto& piece = pieces_[place];
        if (piece.empty())
            piece = made(place);
        const Real x = (w - (static_cast<Real>(place) + 0.5L) * width) / (width / 2);
        Real next = 0, after = 0; // Clenshaw's recurrence
        for (auto n = piece.size(); n-- > 1;)
            after = std::exchange(next, 2 * x * next - after + piece[n]);
        return std::log(x * next - after + piece[0]) - w * w / 4;
    }

  private:
    static constexpr Real width = 0.25L;
    static constexpr std::size_t terms = 20;

    // Chebyshev's coefficients by his nodes.
    std::vector<Real> made(std::size_t place) {
        std::vector<Real> piece(terms, 0);
        constexpr auto count = static_cast<Real>(terms);
        for (std::size_t i = 0; i < terms; ++i) {
            const Real angle = std::numbers::pi_v<Real> * (static_cast<Real>(i) + 0.5L) / count;
            const Real w = (static_cast<Real>(place) + 0.5L + std::cos(angle) / 2) * width;
            const Real value = std::exp(range_.log_upper(w) + w * w / 4);
            for (std::size_t n = 0; n < terms; ++n)
                piece[n] +=
                    (n == 0 ? 1 : 2) / count * value * std::cos(static_cast<Real>(n) * angle);
        }
        return piece;
    }

    InfiniteRange range_;
    std::vector<std::vector<Real>> pieces_;
};

// Sum of exponentials whose exponents may lie outside any floating format.
class LogSum {
  public:
    /// False when the term was negligible.
    bool add(Real exponent) {
        if (exponent > peak_) {
            sum_ *= std::exp(peak_ - exponent);
            peak_ = exponent;
        }
        const Real term = std::exp(exponent - peak_);
        sum_ += term;
        return term > negligible * sum_;
    }

    Real log() const { return peak_ + std::log(sum_); }

  private:
    Real peak_ = -std::numeric_limits<Real>::infinity();
    Real sum_ = 0;
};

enum class Side { Lower, Upper };

// The integrand is about as wide in u as the deviation and the range allow: 1/sqrt(2 nu) for the
// one; for the other 1/sqrt(2 n) where tail(w) goes as w^n, and 1/ln k in its middle.
double deviation_step(Side side, double k, double nu) {
    const double many = std::max(1.0, std::log(k) / std::log(8.0));
    if (side == Side::Upper)
        return std::min(0.094 / (many * many), 0.36 / std::sqrt(nu));
    return std::min(0.077 / (many * many), 0.33 / std::sqrt(nu + k - 1));
}

class StudentizedRange {
  public:
    StudentizedRange(double k, double df, double step_scale)
        : k_(k), nu_(df), step_scale_(step_scale), range_(k, step_scale),
          scale_(std::isinf(df) ? 0 : log_deviation_scale(df)) {}

    Real log_tail(Side side, double q) {
        const auto infinite = [&](Real w) {
            return side == Side::Upper ? range_.log_upper(w) : range_.log_lower(w);
        };
        if (std::isinf(nu_))
            return std::min<Real>(0, infinite(q));
        const Real h = step_scale_ * deviation_step(side, k_, nu_);
        LogSum sum;
        for (const int direction : {1, -1}) {
            int quiet = 0;
            for (int j = direction > 0 ? 0 : -1; quiet < quiet_terms; j += direction) {
                const Real u = j * h;
                const Real weight = nu_ * deviation_exponent(u);
                quiet = sum.add(weight + infinite(q * std::exp(u))) ? 0 : quiet + 1;
            }
        }
        return std::min<Real>(0, scale_ + std::log(h) + sum.log());
    }

  private:
    double k_, nu_, step_scale_;
    InfiniteRange range_;
    Real scale_;
};

Tail tail_of_log(Real log_p) {
    return {static_cast<double>(std::exp(log_p)),
            static_cast<double>(log_p / std::numbers::ln10_v<Real>)};
}

// What needs no integral: NaN, and where everything or nothing is beyond q.
std::optional<Tail> plain_tail(Side side, double q) {
    if (std::isnan(q))
        return Tail{q, q};
    if (q <= 0 || std::isinf(q))
        return (q > 0) == (side == Side::Lower) ? Tail{1, 0}
                                                : Tail{0, -std::numeric_limits<double>::infinity()};
    return std::nullopt;
}

Tail tail_of(Side side, double q, double k, double df, double step_scale) {
    EXPECTS(k >= 2 && std::isfinite(k) && df > 0 && step_scale > 0);
    if (const auto plain = plain_tail(side, q))
        return *plain;
    return tail_of_log(StudentizedRange(k, df, step_scale).log_tail(side, q));
}

} // namespace

Tail studentized_range_upper_tail(double q, double k, double df, double step_scale) {
    return tail_of(Side::Upper, q, k, df, step_scale);
}

Tail studentized_range_lower_tail(double q, double k, double df, double step_scale) {
    return tail_of(Side::Lower, q, k, df, step_scale);
}

// For one number of degrees of freedom the nodes in u stay, with their weights and e^u.
struct StudentizedRanges::Shared {
    struct Node {
        Real weight, scale;
    };

    explicit Shared(double groups) : k(groups), range(groups) {}

    void lay_nodes(double df) {
        nu = df;
        h = deviation_step(Side::Upper, k, nu);
        scale = log_deviation_scale(df);
        for (auto* nodes : {&up, &down})
            nodes->clear();
    }

    const Node& node(bool upward, std::size_t place) {
        auto& nodes = upward ? up : down;
        while (nodes.size() <= place) {
            const auto j = static_cast<Real>(nodes.size());
            const Real u = h * (upward ? j : -1 - j);
            nodes.push_back({nu * deviation_exponent(u), std::exp(u)});
        }
        return nodes[place];
    }

    Real log_upper(Real q) {
        LogSum sum;
        for (const bool upward : {true, false}) {
            int quiet = 0;
            for (std::size_t place = 0; quiet < quiet_terms; ++place) {
                const auto [weight, e_to_u] = node(upward, place);
                quiet = sum.add(weight + range.log_upper(q * e_to_u)) ? 0 : quiet + 1;
            }
        }
        return std::min<Real>(0, scale + std::log(h) + sum.log());
    }

    double k, nu = 0;
    RangePieces range;
    Real h = 0, scale = 0;
    std::vector<Node> up, down; ///< u = 0, h, 2h, ... and -h, -2h, ...
};

StudentizedRanges::StudentizedRanges(double k) : shared_(std::make_unique<Shared>(k)) {
    EXPECTS(k >= 2 && std::isfinite(k));
}

StudentizedRanges::~StudentizedRanges() = default;

Tail StudentizedRanges::upper_tail(double q, double df) {
    EXPECTS(df > 0);
    if (const auto plain = plain_tail(Side::Upper, q))
        return *plain;
    if (std::isinf(df))
        return tail_of_log(std::min<Real>(0, shared_->range.log_upper(q)));
    if (shared_->nu != df)
        shared_->lay_nodes(df);
    return tail_of_log(shared_->log_upper(q));
}

// The tail falls along almost a straight line in (ln q, ln p), so a secant needs five to eight
// steps; it keeps a bracket and halves it whenever it would step outside.
double studentized_range_quantile(double upper_p, double k, double df) {
    EXPECTS(upper_p > 0 && upper_p < 1 && k >= 2 && std::isfinite(k) && df > 0);
    const Side side = upper_p <= 0.5 ? Side::Upper : Side::Lower;
    const Real target = std::log(static_cast<Real>(side == Side::Upper ? upper_p : 1 - upper_p));
    StudentizedRange range(k, df, 1.0);
    const auto excess = [&](double x) { // falls with x = ln q
        const auto gap = static_cast<double>(range.log_tail(side, std::exp(x)) - target);
        return side == Side::Upper ? gap : -gap;
    };
    // Bonferroni's bound over the pairs starts the search; it is close where p is small.
    const double pairs = k * (k - 1) / 2;
    double x =
        std::log(std::numbers::sqrt2 * t_quantile_two_sided(std::min(upper_p / pairs, 0.9), df));
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    double before_x = 0, before = 0;
    for (int evaluation = 0; evaluation < 200; ++evaluation) {
        const double value = excess(x);
        (value > 0 ? low : high) = x;
        if (value == 0)
            return std::exp(x);
        const double slope = evaluation == 0 ? -1.0 : (value - before) / (x - before_x);
        double step = slope < 0 ? std::clamp(-value / slope, -2.0, 2.0) : (value > 0 ? 0.5 : -0.5);
        if (std::abs(step) <= 2e-16 * std::max(1.0, std::abs(x)))
            return std::exp(x);
        if (!(x + step > low && x + step < high)) {
            step = (low + high) / 2 - x;
            if (std::abs(step) <= 4e-16 * std::max(1.0, std::abs(x)))
                return std::exp(x);
        }
        before_x = x;
        before = value;
        x += step;
        if (x == before_x)
            return std::exp(x);
    }
    return std::exp(x);
}

} // namespace analysis::numerics
