// A stimulus as the session's screen is sent it: 8-bit code values.
#pragma once

#include "experiment/read_study.h"
#include "protocols/vocabulary.h"
#include "renderer/gpu/pixel_canvas.h"

#include <tl/expected.hpp>

namespace experiment::stimuli {

/// Eight bits per channel.  A file of 8 bits is taken code by code; one of 16 bits is rounded with
/// ordered dither, the same for every picture.
/// Errors: missing, not a picture, not of the study's size.
tl::expected<renderer::gpu::Picture8, std::string>
picture_for_display(const LoadedStudy& loaded, const protocols::Picture& picture);

} // namespace experiment::stimuli
