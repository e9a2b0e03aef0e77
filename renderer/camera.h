// A model on a turntable before a fixed camera.  Conventions: docs/conventions.md#geometry
#pragma once

#include "renderer/geometry/mesh.h"
#include "renderer/scene.h"
#include "renderer/units.h"

#include <glm/vec3.hpp>

namespace renderer {

/// The world's y axis is the turntable's, and the camera looks from +z toward -z.
struct Turntable {
    double turn_degrees = 0;      ///< of the model, counter-clockwise seen from above
    double elevation_degrees = 0; ///< the camera's height above the horizon, -90..90
    glm::dvec3 up{0, 1, 0};       ///< which way is up in the model's coordinates
};

/// Puts the centre of the model's bounding sphere at the world's origin, its `up` along y, turned,
/// and scaled so that the sphere's diameter is `diameter`.
/// Errors: EXPECTS positive diameter and radius, and an `up` that has a length.
Placement place(const geometry::BoundingSphere& model, Millimetres diameter, const Turntable&);

/// A perspective camera that looks at the origin and shows a sphere of `diameter` there with a
/// margin of 4 % of its radius; the field of view is 30 degrees along the picture's shorter edge.
/// Errors: EXPECTS positive diameter and `aspect` (width over height), elevation within range.
Camera frame(Millimetres diameter, const Turntable&, double aspect);

/// A direction given in view axes (x right, y up, z toward the viewer), in world axes.
glm::dvec3 world_from_view_axes(const Camera& camera, glm::dvec3 direction);

} // namespace renderer
