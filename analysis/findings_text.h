// Findings as tables for a terminal.
#pragma once

#include "analysis/findings.h"

#include <string>

namespace analysis {

/// Design, ranking, vote matrix, default analysis, pairs, "as in the paper", notes; lines stay
/// within 100 columns for usual names, p with 3 significant digits.
std::string findings_text(const Findings& findings);

/// "0.0121", "5.19e-12", "< 1e-300 (log10 p = -367.0)", "n/e" when undefined.
std::string p_text(double p, double log10_p = 0);

/// The same with its relation: "p = 0.0121", "p < 1e-300 (log10 p = -367.0)".
std::string p_phrase(double p, double log10_p = 0);

} // namespace analysis
