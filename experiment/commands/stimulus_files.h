// The pictures of a sitting, which must be the same files from its beginning to its end.
#pragma once

#include "experiment/read_study.h"
#include "experiment/session/pair_cache.h"

#include <map>
#include <string>

namespace experiment::commands {

/// SHA-256 of every picture's file, hexadecimal.
using StimulusDigests = std::map<protocols::Picture, std::string>;

/// Errors: a file that cannot be read.
tl::expected<StimulusDigests, std::string> stimulus_digests(const LoadedStudy& loaded);

/// One digest over all of them and their names.
std::string digest_of(const StimulusDigests& digests);

/// Loads pictures for the display.  `loaded` has to outlive it.
/// Errors of its calls: a file that is gone, or is not what it was when its digest was taken.
session::LoadPicture load_unchanged(const LoadedStudy& loaded, StimulusDigests digests);

} // namespace experiment::commands
