// How much of the surface each vertex stands for.
#pragma once

#include "renderer/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace renderer::thickness {

/// Each vertex's share of the surface, a third of the triangles around it, in units of 2^-40 of the
/// whole: integers, which add up the same in every order.
/// Errors: EXPECTS a surface with an area.
std::vector<std::uint64_t> surface_shares(const geometry::Mesh& mesh);

} // namespace renderer::thickness
