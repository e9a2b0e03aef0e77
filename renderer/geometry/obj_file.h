// Reads Wavefront OBJ, by tinyobjloader.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"

#include <string_view>

namespace renderer::geometry {

/// Reads the shape in the text of an OBJ file: all objects and groups become one mesh, polygons
/// become fans, indices may count back from the end; materials, normals and texture coordinates are
/// passed over.  Coordinates are right to a few units in the last place of a double.
/// Errors: "<name>:<line>: ..." for vertices and faces that are not what they should be.
Expected<Mesh> read_obj(std::string_view text, std::string_view name);

} // namespace renderer::geometry
