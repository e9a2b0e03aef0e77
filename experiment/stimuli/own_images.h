// Pictures made elsewhere: there, opaque, and of the study's size.
#pragma once

#include "experiment/read_study.h"
#include "experiment/stimuli/manifest.h"

#include <tl/expected.hpp>

namespace experiment::stimuli {

/// The record of an own image as it lies in the stimuli folder.
/// Errors: missing, not a picture, not of the study's size; names the file and what was expected.
tl::expected<PictureRecord, std::string> inspect_own_image(const LoadedStudy& loaded,
                                                           const protocols::Picture& picture);

} // namespace experiment::stimuli
