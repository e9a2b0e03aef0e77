// Standard errors are read from the whole covariance.
#include "analysis/scaling/choice_fit.h"

#include <cmath>

namespace analysis::scaling {

double standard_error(const ChoiceFit& fit, std::size_t i) {
    return std::sqrt(fit.covariance[i * fit.conditions() + i]);
}

double difference_standard_error(const ChoiceFit& fit, std::size_t i, std::size_t j) {
    const std::size_t t = fit.conditions();
    return std::sqrt(fit.covariance[i * t + i] + fit.covariance[j * t + j] -
                     2 * fit.covariance[i * t + j]);
}

ChoiceFit in_unit(ChoiceFit fit, double factor) {
    for (double& value : fit.theta)
        value *= factor;
    for (double& value : fit.covariance)
        value *= factor * factor;
    if (fit.side)
        fit.side = Nuisance{fit.side->value * factor, fit.side->standard_error * factor};
    return fit;
}

} // namespace analysis::scaling
