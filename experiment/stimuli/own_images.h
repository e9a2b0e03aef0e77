// Pictures made elsewhere: there, opaque, and of their scene's size.
#pragma once

#include "experiment/read_study.h"
#include "experiment/stimuli/manifest.h"
#include "renderer/imaging/encoded_image.h"

#include <tl/expected.hpp>

namespace experiment::stimuli {

/// Errors: `image`, read from `file`, is not of the size that the study says for its scene.
tl::expected<void, std::string> expect_size(const LoadedStudy& loaded,
                                            const protocols::Picture& picture,
                                            const std::filesystem::path& file,
                                            const renderer::imaging::EncodedImage& image);

/// The record of an own image as it lies in the stimuli folder.
/// Errors: missing, not a picture, not of its scene's size; names the file and what was expected.
tl::expected<PictureRecord, std::string> inspect_own_image(const LoadedStudy& loaded,
                                                           const protocols::Picture& picture);

} // namespace experiment::stimuli
