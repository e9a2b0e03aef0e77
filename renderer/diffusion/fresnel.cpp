// Fresnel's equations for dielectrics, and Gauss quadrature of them.
#include "renderer/diffusion/fresnel.h"

#include "renderer/contract.h"
#include "renderer/harmonics/gauss_legendre.h"

#include <algorithm>
#include <cmath>

namespace renderer::diffusion {

namespace {

/// The diffuse mean for eta > 1, where nothing is totally reflected.  F falls from 1 within about
/// sqrt(eta^2 - 1) of grazing; mu = t^3 crowds the nodes there, and 64 of them give ten digits.
double mean_from_the_thinner_side(double eta) {
    double sum = 0;
    for (const auto& [x, weight] : harmonics::gauss_legendre(64)) {
        const double t = 0.5 * (1 + x);
        sum += 0.5 * weight * 6 * std::pow(t, 5) * fresnel_reflectance(t * t * t, eta);
    }
    return sum;
}

} // namespace

double fresnel_reflectance(double cosine, double eta) {
    if (eta == 1)
        return 0;
    const double mu = std::clamp(cosine, 0.0, 1.0);
    const double sine_inside_squared = (1 - mu * mu) / (eta * eta);
    if (sine_inside_squared >= 1)
        return 1;
    const double inside = std::sqrt(1 - sine_inside_squared);
    const double parallel = (eta * mu - inside) / (eta * mu + inside);
    const double across = (mu - eta * inside) / (mu + eta * inside);
    return 0.5 * (parallel * parallel + across * across);
}

double external_diffuse_reflectance(double eta) {
    EXPECTS(eta > 0);
    if (eta >= 1)
        return eta == 1 ? 0 : mean_from_the_thinner_side(eta);
    return 1 - eta * eta * (1 - internal_diffuse_reflectance(eta));
}

double internal_diffuse_reflectance(double eta) {
    EXPECTS(eta > 0);
    if (eta == 1)
        return 0;
    // Seen from inside, a thinner medium is the outside of a boundary with the inverse index.
    return eta > 1 ? 1 - (1 - mean_from_the_thinner_side(eta)) / (eta * eta)
                   : mean_from_the_thinner_side(1 / eta);
}

} // namespace renderer::diffusion
