#include "analysis/numerics/deviation_density.h"

#include <cmath>
#include <numbers>

namespace analysis::numerics {
namespace {

using Real = long double;

// ln Gamma(x), x > 0, by Stirling's series beyond 20 and the recurrence below.
Real log_gamma(Real x) {
    Real product = 1;
    for (; x < 20; ++x)
        product *= x;
    const Real y = 1 / (x * x);
    const Real series =
        (1.0L / 12 -
         y * (1.0L / 360 -
              y * (1.0L / 1260 -
                   y * (1.0L / 1680 - y * (1.0L / 1188 - y * (691.0L / 360360 - y / 156)))))) /
        x;
    return (x - 0.5L) * std::log(x) - x + std::log(2 * std::numbers::pi_v<Real>) / 2 + series -
           std::log(product);
}

} // namespace

// c of the density of u = ln s.  The plain form loses digits when nu is large: 2e-10 at 1e6.
Real log_deviation_scale(Real nu) {
    if (nu <= 80)
        return std::numbers::ln2_v<Real> + nu / 2 * std::log(nu / 2) - log_gamma(nu / 2) - nu / 2;
    const Real i = 1 / nu, i2 = i * i;
    return std::log(nu / std::numbers::pi_v<Real>) / 2 -
           i * (1.0L / 6 -
                i2 * (1.0L / 45 - i2 * (8.0L / 315 - i2 * (8.0L / 105 - i2 * 128.0L / 297))));
}

// u - expm1(2u) / 2 = -(u^2 + 2 u^3 / 3 + ...): the difference would cancel near 0.
Real deviation_exponent(Real u) {
    if (std::abs(u) > 0.1L)
        return u - std::expm1(2 * u) / 2;
    Real term = u, sum = 0;
    for (int m = 2; m < 30; ++m) {
        term *= 2 * u / static_cast<Real>(m);
        sum -= term;
    }
    return sum;
}

} // namespace analysis::numerics
