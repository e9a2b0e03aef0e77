// How often a closed surface winds around a point.  [Jacobson2013]
#pragma once

#include "renderer/geometry/mesh.h"

#include <span>

namespace renderer::geometry {

/// Generalised winding number: the solid angle of all triangles seen from `point`, over 4 pi.
/// 1 inside one closed surface, 0 outside, in between near holes; 2 where two bodies overlap.
/// Cost: three square roots and a complex product per triangle.
double winding_number(std::span<const glm::vec3> positions,
                      std::span<const Triangle> triangles,
                      glm::dvec3 point);

} // namespace renderer::geometry
