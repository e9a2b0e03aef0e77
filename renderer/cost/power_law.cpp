// Least squares on logarithms, about their means.
#include "renderer/cost/power_law.h"

#include "renderer/contract.h"

#include <algorithm>
#include <cmath>

namespace renderer::cost {

std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y) {
    EXPECTS(x.size() == y.size());
    const auto usable = [](double value) { return value > 0 && std::isfinite(value); };
    if (x.size() < 3 || !std::all_of(x.begin(), x.end(), usable) ||
        !std::all_of(y.begin(), y.end(), usable))
        return std::nullopt;
    const auto n = static_cast<double>(x.size());
    double mean_u = 0, mean_v = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_u += std::log(x[i]) / n;
        mean_v += std::log(y[i]) / n;
    }
    double uu = 0, uv = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double u = std::log(x[i]) - mean_u;
        uu += u * u;
        uv += u * (std::log(y[i]) - mean_v);
    }
    if (!(uu > 1e-12 * n)) // the same x again and again
        return std::nullopt;
    PowerLaw law{.exponent = uv / uu, .points = x.size()};
    law.factor = std::exp(mean_v - law.exponent * mean_u);
    double squares = 0, worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double rest = std::log(y[i]) - std::log(law.factor) - law.exponent * std::log(x[i]);
        squares += rest * rest;
        worst = std::max(worst, std::abs(rest));
    }
    law.standard_error = std::sqrt(squares / (n - 2) / uu);
    law.worst_ratio = std::exp(worst);
    return law;
}

} // namespace renderer::cost
