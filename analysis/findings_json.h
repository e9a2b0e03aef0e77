// Findings as one JSON document: every number with all its digits, null and a reason for what is
// undefined.
#pragma once

#include "analysis/findings.h"

#include <string>

namespace analysis {

/// Keys and structure are those that scripts rely on: `paper_score`, `anova` with
/// `oneway_observer_means`, `rm_method`, ..., beside `design`, `ranking`, `vote_matrices` and
/// `notes`.  Infinite values are the text "inf".
std::string findings_json(const Findings& findings);

} // namespace analysis
