// Given the control's mean z and the deviation s the T's are independent:
//   P = Int f(s) Int phi(z) {1 - prod [1 - Q((c s - l z)/r) - Q((c s + l z)/r)]} dz ds
// with r = sqrt(1 - l^2).  Trapezoids in z and ln s, as for the studentized range.
#include "analysis/numerics/dunnett.h"

#include "analysis/numerics/deviation_density.h"
#include "protocols/contract.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

namespace analysis::numerics {
namespace {

using Real = long double;

constexpr double negligible = 1e-18;

// Treatments with the same loading are one factor to a power.
struct Comparisons {
    double slope = 0; ///< l / r
    double scale = 0; ///< 1 / r
    double count = 0;
};

class DunnettIntegral {
  public:
    DunnettIntegral(std::span<const double> loading, double df) : df_(df) {
        std::map<double, double> counts;
        for (const double l : loading) {
            EXPECTS(l > 0 && l < 1);
            ++counts[l];
        }
        double roughness = 1;
        for (const auto& [l, count] : counts) {
            const double r = std::sqrt((1 - l) * (1 + l));
            comparisons_.push_back({l / r, 1 / r, count});
            roughness += count * (l / r) * (l / r);
        }
        // The integrand is about as wide in frequency as this many unit normals together.
        step_ = 0.8 * 2 * std::numbers::pi / std::sqrt(74 * roughness);
    }

    double upper(double c) const {
        if (std::isinf(df_))
            return inner(c);
        const Real h = std::min(0.094, 0.36 / std::sqrt(df_));
        const Real scale = log_deviation_scale(df_);
        Real sum = 0;
        for (const int direction : {1, -1}) {
            int quiet = 0;
            for (int j = direction > 0 ? 0 : -1; quiet < 4; j += direction) {
                const Real u = j * h;
                const Real term = std::exp(scale + df_ * deviation_exponent(u)) *
                                  static_cast<Real>(inner(c * static_cast<double>(std::exp(u))));
                sum += term;
                // Far upper tails live at small deviations: nothing is negligible before there is
                // something.
                const bool small = sum > 0 ? term <= negligible * sum : u < -30 || u > 3;
                quiet = small ? quiet + 1 : 0;
            }
        }
        return static_cast<double>(std::min<Real>(1, h * sum));
    }

  private:
    // With a known deviation; even in z.
    double inner(double c) const {
        double sum = given_control(c, 0) / 2;
        for (int j = 1; j * step_ < 40; ++j) {
            const double z = j * step_;
            sum += std::exp(-z * z / 2) * given_control(c, z);
        }
        return 2 * step_ * sum / std::sqrt(2 * std::numbers::pi);
    }

    double given_control(double c, double z) const {
        double log_all_inside = 0;
        for (const auto& group : comparisons_) {
            const double tail = normal_upper_tail(c * group.scale - group.slope * z).p +
                                normal_upper_tail(c * group.scale + group.slope * z).p;
            if (tail >= 1)
                return 1;
            log_all_inside += group.count * std::log1p(-tail);
        }
        return -std::expm1(log_all_inside);
    }

    double df_;
    double step_ = 0;
    std::vector<Comparisons> comparisons_;
};

} // namespace

Tail dunnett_upper_tail(double c, std::span<const double> loading, double df) {
    EXPECTS(!loading.empty() && df > 0);
    if (std::isnan(c))
        return {c, c};
    if (c <= 0)
        return {1, 0};
    const double p = std::isinf(c) ? 0 : DunnettIntegral(loading, df).upper(c);
    return {p, std::log10(p)};
}

double dunnett_quantile(double p, std::span<const double> loading, double df) {
    EXPECTS(p > 0 && p < 1 && !loading.empty() && df > 0);
    const DunnettIntegral integral(loading, df);
    // One comparison from below, Bonferroni's bound from above.
    const double low = t_quantile_two_sided(p, df) * (1 - 1e-12);
    const double high =
        t_quantile_two_sided(p / static_cast<double>(loading.size()), df) * (1 + 1e-12);
    const auto excess = [&](double c) { return std::log(integral.upper(c) / p); };
    const double below = excess(low), above = excess(high);
    if (!(below > 0) || !(above < 0))
        return loading.size() == 1 ? t_quantile_two_sided(p, df) : (low + high) / 2;
    std::uintmax_t evaluations = 100;
    const auto [left, right] = boost::math::tools::toms748_solve(
        excess, low, high, below, above, boost::math::tools::eps_tolerance<double>(48),
        evaluations);
    return (left + right) / 2;
}

} // namespace analysis::numerics
