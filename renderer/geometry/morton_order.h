// Points in an order that keeps neighbours in space near each other.
#pragma once

#include "renderer/geometry/mesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace renderer::geometry {

/// Indices of all points along a Morton (z-order) curve through -0.5..0.5 in each coordinate;
/// points outside count as on the border.
std::vector<std::uint32_t> morton_order(std::span<const glm::vec3> positions);

/// The same surface with its vertices along the curve through its bounding sphere; triangles keep
/// their order and their corners.  Blocks of consecutive vertices are then patches of the surface.
Mesh along_morton_curve(const Mesh& mesh);

} // namespace renderer::geometry
