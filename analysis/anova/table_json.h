// The analysis of a table of measurements as JSON text.
#pragma once

#include "analysis/anova/table_analysis.h"

#include <string>

namespace analysis::anova {

/// `{"terms": {"A": {"SS","df","MS","F","p",...}, ..., "residual": {"SS","df","MS","sd"}},
/// "r_squared", ...}`: all digits, null for what is undefined with its reason beside it.  `source`
/// says where the values came from.
std::string table_json(const TableAnalysis& analysis, const std::string& source);

} // namespace analysis::anova
