// With a standard deviation s = e^u of nu degrees of freedom, and the tail of the range over a
// known one (normal_range.h),
//   tail(q) = Int exp(c + nu (u - expm1(2u) / 2)) tail_infinite(q e^u) du.
// The integrand is smooth and falls off fast, so the trapezoid converges geometrically; no sum has
// a term of the other sign, so small tails keep their digits.  Steps were chosen by shortening: 10
// % longer outer ones cost a digit, 18 % three.
#include "analysis/numerics/studentized_range.h"

#include "analysis/numerics/deviation_density.h"
#include "analysis/numerics/normal_range.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace analysis::numerics {
namespace {

using Real = long double; // for the outer sum: its exponents of some hundreds cost digits otherwise

constexpr double negligible = 1e-17;
constexpr int quiet_terms = 4; // as many negligible terms in a row end a sum

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
    NormalRange range_;
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
    NormalRangePieces range;
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
