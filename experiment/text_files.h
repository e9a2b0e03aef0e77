// Text files, whole: read with a reason when it fails, written so that a half-written one is never
// seen.
#pragma once

#include <tl/expected.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace experiment {

/// The file's bytes.  Errors: "<path>: cannot be read: <reason of the system>".
tl::expected<std::string, std::string> read_text_file(const std::filesystem::path& path);

/// Writes to a temporary neighbour, then renames.  Creates the folder when it is not there.
/// Errors: "<path>: cannot be written: <reason of the system>".
tl::expected<void, std::string> write_text_file(const std::filesystem::path& path,
                                                std::string_view text);

} // namespace experiment
