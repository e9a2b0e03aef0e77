// Directions from a CSV file with columns x, y, z.
#pragma once

#include <glm/vec3.hpp>
#include <tl/expected.hpp>

#include <filesystem>
#include <vector>

namespace experiment {

/// Unit vectors, one per row, in the file's order.  The header row names x, y and z; other columns
/// are passed over.
/// Errors: "<file>:<line>: ..." for a missing column, a field that is no number, a vector whose
///         length is not 1 within 1e-6, and for a file without rows.
tl::expected<std::vector<glm::dvec3>, std::string>
read_directions(const std::filesystem::path& file);

} // namespace experiment
