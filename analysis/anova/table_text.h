// The analysis of a table of measurements as text for a person.
#pragma once

#include "analysis/anova/table_analysis.h"

#include <string>

namespace analysis::anova {

/// Table, comparisons of levels and checks; what is undefined is "n/e" with its reason.
std::string table_text(const TableAnalysis& analysis);

} // namespace analysis::anova
