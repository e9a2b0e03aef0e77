// Stimuli made small enough to be carried in a report.
#pragma once

#include "experiment/read_study.h"
#include "experiment/report/contents.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace experiment::stimuli {

/// Every picture of the study, by scene, variant and condition, its longer edge at most
/// `greatest_edge` pixels.  Errors: those of reading a picture.
tl::expected<std::vector<report::Thumbnail>, std::string> thumbnails(const LoadedStudy& loaded,
                                                                     int greatest_edge = 320);

} // namespace experiment::stimuli
