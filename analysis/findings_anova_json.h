// The analyses of variance and the rank tests of the findings as JSON text.
#pragma once

#include "analysis/findings.h"

#include <string>

namespace analysis {

/// The object `anova` of the findings; with a reason in place of tables when there are none.
std::string anova_json(const Findings& findings);

/// The objects `friedman_observer_means` and `nemenyi`.  EXPECTS findings that have them.
std::string friedman_json(const Findings& findings);
std::string nemenyi_json(const Findings& findings);

} // namespace analysis
