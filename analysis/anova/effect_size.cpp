#include "analysis/anova/effect_size.h"

#include "analysis/numerics/noncentrality.h"
#include "protocols/contract.h"

#include <cmath>
#include <limits>

namespace analysis::anova {

EtaInterval eta_squared_interval(double f, double df1, double df2, double level) {
    EXPECTS(level > 0 && level < 1);
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(f) || !(df1 > 0) || !(df2 > 0))
        return {nothing, nothing};
    const double tail = (1 - level) / 2;
    const auto eta = [&](double upper_p) {
        const double lambda = numerics::noncentrality(f, df1, df2, upper_p);
        return lambda / (lambda + df1 + df2 + 1);
    };
    return {eta(tail), eta(1 - tail)};
}

} // namespace analysis::anova
