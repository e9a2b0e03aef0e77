// Reads meshes from files: PLY, OFF and OBJ.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"

#include <array>
#include <filesystem>
#include <string_view>

namespace renderer::geometry {

/// The endings of the files that are read, in the order in which they are looked for.
inline constexpr std::array<std::string_view, 3> mesh_file_endings{".ply", ".off", ".obj"};

/// Reads the mesh in `file`, by its ending (in either case), exactly as it stands there.
/// Errors: "<file>[:<line>]: ...": not there, not readable, not one of the endings, malformed.
Expected<Mesh> read_mesh(const std::filesystem::path& file);

} // namespace renderer::geometry
