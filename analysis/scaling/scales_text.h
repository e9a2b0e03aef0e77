// The scales as text for a person.
#pragma once

#include "analysis/scaling/scales.h"

#include <string>
#include <vector>

namespace analysis::scaling {

/// A table of scores, best first, and what was tested about them.
std::string scales_text(const Scales& scales, const std::vector<std::string>& conditions);

/// Sentences about how the scales were made, and what to keep in mind when reading them.
std::vector<std::string> scale_notes(const Scales& scales,
                                     const std::vector<std::string>& conditions);

/// Conditions, highest score first.
std::vector<std::size_t> by_score(const ChoiceFit& fit);

} // namespace analysis::scaling
