// Walking toward the light on purpose: the directions and stretched flights of a diffusing
// half-space's lowest mode, after Dwivedi.  [Dwivedi1982] [Meng2016]
#pragma once

#include <glm/vec3.hpp>

namespace renderer::reference {

/// The rate at which light dies away in a medium of `albedo` < 1, over its extinction: 1 / nu.
/// Source: [Meng2016], the fit for isotropic scattering; 0 at albedo 1, where nothing is gained.
double decay_rate(double albedo);

/// The cosine to the axis, drawn with `u` in [0, 1), for a `rate` in 0..1 (exclusive).
double sample_guided_cosine(double u, double rate);

/// Per steradian, of a direction with `cosine` to the axis.
double guided_density(double cosine, double rate);

/// The extinction with which flights are drawn in that direction, over the true one: longer flights
/// along the axis, shorter ones against it.
inline double guided_stretch(double cosine, double rate) {
    return 1 - cosine * rate;
}

} // namespace renderer::reference
