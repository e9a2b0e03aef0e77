// Reads and writes OFF, the Object File Format of Geomview.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"

#include <string>
#include <string_view>

namespace renderer::geometry {

/// Reads the text of an OFF file: one vertex or face to a line, comments after #, counts on the
/// first line or the next.  Normals, colours and texture coordinates (NOFF, COFF, STOFF and their
/// combinations, colours of faces) are passed over; polygons become fans.
/// Errors: "<name>:<line>: ..." for anything but that, including binary and four-dimensional OFF.
Expected<Mesh> read_off(std::string_view text, std::string_view name);

/// The mesh as OFF, with as many digits as bring every position back.
std::string off_text(const Mesh& mesh);

} // namespace renderer::geometry
