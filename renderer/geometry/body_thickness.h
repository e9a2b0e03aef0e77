// How much material lies along a ray through the bodies of bodies.h, in closed form.
#pragma once

#include <glm/vec3.hpp>

namespace renderer::geometry {

/// Lengths along one ray from a point, in the body's units; 0 where the ray meets no material.
struct BodyThickness {
    double sum = 0;   ///< of all stretches inside the material
    double first = 0; ///< the stretch that starts at the point, if there is one
    double span = 0;  ///< from the point to the last exit, gaps counted
};

// For all of these: `p` anywhere, `s` a unit vector (EXPECTS, 1e-6), bodies as bodies.h places
// them. A stretch that begins within 1e-9 of the body's size starts at the point: that is what
// rounding makes of a point on the surface.

BodyThickness sphere_thickness(double radius, glm::dvec3 p, glm::dvec3 s);

BodyThickness shell_thickness(double outer_radius, double inner_radius, glm::dvec3 p, glm::dvec3 s);

/// By the real roots of the quartic, isolated between the extrema of the polynomial and bisected,
/// so that a ray that grazes the ring loses no digits but the graze.
BodyThickness torus_thickness(double major_radius, double minor_radius, glm::dvec3 p, glm::dvec3 s);

BodyThickness
slab_thickness(double width, double height, double thickness, glm::dvec3 p, glm::dvec3 s);

/// Axis-aligned, centred at the origin.
BodyThickness ellipsoid_thickness(glm::dvec3 semi_axes, glm::dvec3 p, glm::dvec3 s);

} // namespace renderer::geometry
