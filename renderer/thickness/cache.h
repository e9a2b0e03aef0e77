// Thickness fields in files, so that a mesh is traced once.  Format: docs/thickness.md.
//
// A file is used only for exactly the mesh and the options it was traced for, by the version of the
// program's tracing that wrote it, and only whole: everything in it is under one checksum.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"
#include "renderer/thickness/thickness_field.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace renderer::thickness {

/// Tells meshes apart by all their positions, triangles and numbers of them, in their order.
std::uint64_t mesh_hash(const geometry::Mesh& mesh);

/// The field in `file`, bit for bit as it was written.  nullopt when there is no such file or what
/// it holds is of no use here: another mesh, kind, rotation or number of directions, fewer bands
/// than `options.bands`, another version of the format, another byte order.  A field of more bands
/// serves: it is returned as it is.
/// Errors: "<file>: ..." for a file that cannot be read or is damaged.
Expected<std::optional<ThicknessField>>
read_field(const std::filesystem::path& file, std::uint64_t mesh, const FieldOptions& options);

/// Writes a neighbour with a name of its own, flushes it to the disk and gives it `file`'s name: a
/// reader finds the old file or the new one, whole, whoever else writes.
/// Errors: "<file>: ..." when the folder is not there or not writable, or the disk is full; then
/// nothing is left behind.
Expected<void>
write_field(const std::filesystem::path& file, std::uint64_t mesh, const ThicknessField& field);

} // namespace renderer::thickness
