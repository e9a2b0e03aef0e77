// A mesh as it grows while a file is read: nothing enters that later code could trip over.
#pragma once

#include "renderer/geometry/mesh.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace renderer::geometry {

/// What is wrong, without the place; nothing when all is well.
using Problem = std::optional<std::string>;

/// Appends a vertex whose coordinates are finite.
Problem append_vertex(Mesh& mesh, glm::dvec3 position);

/// Appends a polygon as a fan of triangles around its first corner.
/// `corners` are indices from 0, as the file gave them; the mesh will have `vertices` vertices.
Problem append_polygon(Mesh& mesh, std::span<const double> corners, std::size_t vertices);

/// Whether `count` things of at least `least_bytes` each (at least 1) fit into `bytes`, and can be
/// numbered with 32 bits: asked before any memory is taken for them.
Problem
check_count(std::string_view things, std::size_t count, std::size_t least_bytes, std::size_t bytes);

} // namespace renderer::geometry
