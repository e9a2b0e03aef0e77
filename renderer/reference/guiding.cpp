// Dwivedi's mode: density 1 / ((nu - mu) ln((nu + 1) / (nu - 1))) of the cosine mu.
#include "renderer/reference/guiding.h"

#include "renderer/contract.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer::reference {

namespace {

/// ln((nu + 1) / (nu - 1))
double log_quotient(double rate) {
    return std::log1p(rate) - std::log1p(-rate);
}

} // namespace

double decay_rate(double albedo) {
    EXPECTS(albedo >= 0 && albedo <= 1);
    if (albedo == 0)
        return 1;
    const double power = 2.44294 - 0.0215813 * albedo + 0.578637 / albedo;
    return std::sqrt(std::max(0.0, 1 - std::pow(albedo, power)));
}

double sample_guided_cosine(double u, double rate) {
    const double nu = 1 / rate;
    return std::clamp(nu - (nu + 1) * std::exp(-u * log_quotient(rate)), -1.0, 1.0);
}

double guided_density(double cosine, double rate) {
    return rate / ((1 - rate * cosine) * log_quotient(rate) * 2 * std::numbers::pi);
}

} // namespace renderer::reference
