// Pictures made elsewhere: there, opaque, and of their scene's size.
#pragma once

#include "experiment/read_study.h"
#include "experiment/stimuli/manifest.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <string>

namespace experiment::stimuli {

/// Looks at the beginning of the file only, so that no pixel of a picture is read in vain.
/// Errors: no picture, or not of the size that the study says for its scene.
tl::expected<void, std::string> expect_size(const LoadedStudy& loaded,
                                            const protocols::Picture& picture,
                                            const std::filesystem::path& file);

/// The record of an own image as it lies in the stimuli folder.
/// Errors: missing, not a picture, not of its scene's size; names the file and what was expected.
tl::expected<PictureRecord, std::string> inspect_own_image(const LoadedStudy& loaded,
                                                           const protocols::Picture& picture);

} // namespace experiment::stimuli
