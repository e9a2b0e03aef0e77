// The scales part of the findings as JSON text.
#pragma once

#include "analysis/scaling/scales.h"

#include <string>
#include <vector>

namespace analysis::scaling {

/// The object `choice_models` of the findings; null for what is undefined, with its reason.
std::string scales_json(const Scales& scales, const std::vector<std::string>& conditions);

} // namespace analysis::scaling
