#include "analysis/numerics/noncentrality.h"

#include "analysis/numerics/distributions.h"
#include "protocols/contract.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <limits>

namespace analysis::numerics {

double noncentrality(double f, double df1, double df2, double upper_p) {
    EXPECTS(df1 > 0 && df2 > 0 && std::isfinite(df1) && std::isfinite(df2));
    EXPECTS(upper_p > 0 && upper_p < 1);
    if (!std::isfinite(f))
        return std::numeric_limits<double>::quiet_NaN();
    // The smaller tail keeps its digits; both rise through 0 with lambda.
    const auto excess = [&](double lambda) {
        return upper_p <= 0.5 ? noncentral_f_upper_tail(f, df1, df2, lambda).p - upper_p
                              : (1 - upper_p) - noncentral_f_lower_tail(f, df1, df2, lambda).p;
    };
    const double at_zero = excess(0);
    if (at_zero >= 0)
        return 0;
    double low = 0, below = at_zero, high = df1 * std::max(f, 1.0), above = excess(high);
    while (above < 0) {
        low = high;
        below = above;
        high *= 2;
        above = excess(high);
    }
    if (above == 0)
        return high;
    std::uintmax_t evaluations = 200;
    const auto [left, right] = boost::math::tools::toms748_solve(
        excess, low, high, below, above, boost::math::tools::eps_tolerance<double>(48),
        evaluations);
    return (left + right) / 2;
}

} // namespace analysis::numerics
