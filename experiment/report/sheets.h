// The parts of a report about stimuli, sittings and circumstances, as HTML.
#pragma once

#include "experiment/report/contents.h"

#include <string>
#include <vector>

namespace experiment::report {

/// Scenes and variants down, conditions across.
std::string contact_sheet(const ReportContents& contents);

/// Targets and gains: scenes and variants down, conditions across.
std::string brightness_table(const ReportContents& contents);

std::string sitting_table(const std::vector<SittingRow>& sittings);

/// Names and values; "not recorded" where there is none.
std::string fact_list(const std::vector<Fact>& facts);

} // namespace experiment::report
