// The consistency part of the findings as JSON text.
#pragma once

#include "analysis/consistency/consistency.h"

#include <string>
#include <vector>

namespace analysis::consistency {

/// The object `paired_comparison` of the findings; null for what is undefined.
std::string consistency_json(const Consistency& found,
                             const std::vector<std::string>& conditions,
                             const std::vector<std::string>& factor_names);

} // namespace analysis::consistency
