// Whether the pictures that lie there are those the study asks for.
#pragma once

#include "experiment/read_study.h"

#include <tl/expected.hpp>

namespace experiment::stimuli {

/// Every picture is there, holds the bytes that were rendered, and was rendered from this study as
/// it stands; own images are there and of the study's size. Errors: the first that is not, and what
/// to do about it.
tl::expected<void, std::string> check_stimuli(const LoadedStudy& loaded);

} // namespace experiment::stimuli
