// Where light comes from: everywhere alike, suns far away, lamps nearby.
#pragma once

#include "renderer/expected.h"
#include "renderer/reference/boundary.h"
#include "renderer/reference/medium.h"
#include "renderer/units.h"

#include <glm/vec3.hpp>

#include <vector>

namespace renderer::reference {

/// A light infinitely far away: a direction, or a disc of even radiance around it.
struct Sun {
    glm::dvec3 to_light{0, 0, 1}; ///< unit, toward its centre
    Spectrum<3> irradiance{};     ///< on a surface that faces it, E
    Radians half_angle{0};        ///< 0: all from one direction
};

/// A point nearby, outside the body.
struct Lamp {
    glm::dvec3 position{0, 0, 1};
    Spectrum<3> irradiance{}; ///< on a surface that faces it at the distance `reference`
    double reference = 1;
};

struct Illumination {
    Spectrum<3> sky{}; ///< radiance from everywhere
    std::vector<Sun> suns;
    std::vector<Lamp> lamps;
};

/// Solid angle of the sun's disc; 0 for a direction.
double solid_angle(const Sun& sun);

/// Whether unit `direction` points into the sun's disc; never for a single direction.
bool is_toward(const Sun& sun, glm::dvec3 direction);

/// A direction to the sun, uniform over its disc.
glm::dvec3 sample(const Sun& sun, double u1, double u2);

/// Whether paths can find this light through that boundary.
/// Errors: a smooth boundary bends light, so that a lamp, or a sun of less than 2 degrees'
///         half-angle, cannot be reached (exactly: a direction never, a small disc too rarely to
///         trust); a roughness outside 0.1..1; what to use instead.
Expected<void> check_reachable(const Illumination& illumination, const Boundary& boundary);

} // namespace renderer::reference
