// A reference on disk: an EXR picture that knows its error and can be gone on with.
#pragma once

#include "renderer/reference/film.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <string>

namespace experiment::stimuli {

struct StoredReference {
    renderer::reference::Film film;
    std::string recipe; ///< what was rendered, in words that are equal when it is
};

/// Errors: the file cannot be written.
tl::expected<void, std::string> write_reference(const std::filesystem::path& file,
                                                const StoredReference& reference);

/// Errors: the file is missing, or not one that `write_reference` wrote.
tl::expected<StoredReference, std::string> read_reference(const std::filesystem::path& file);

} // namespace experiment::stimuli
