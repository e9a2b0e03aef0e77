// Reads PLY, the polygon file format of Stanford's scans.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"

#include <string_view>

namespace renderer::geometry {

/// Reads a PLY file from its bytes: text, or binary of either endianness; properties of any type;
/// elements and properties other than x, y, z and vertex_indices (or vertex_index) are passed over,
/// polygons become fans.
/// Errors: "<name>:<line>: ..." in a text, "<name>: byte <n>: ..." in binary data.
Expected<Mesh> read_ply(std::string_view bytes, std::string_view name);

} // namespace renderer::geometry
