// The stimuli in small, for the report's contact sheet.
#pragma once

#include "experiment/read_study.h"
#include "experiment/report/contents.h"

#include <tl/expected.hpp>

#include <functional>
#include <vector>

namespace experiment::stimuli {

/// Every picture of the study that is there, at most 160 pixels along its longer edge.
tl::expected<std::vector<report::Thumbnail>, std::string>
thumbnails(const LoadedStudy& loaded, const std::function<void(double)>& progress);

} // namespace experiment::stimuli
