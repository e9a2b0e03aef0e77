// The mark that simulated votes carry on every page, figure and table.
#pragma once

#include "experiment/report/contents.h"

#include <string>

namespace experiment::report {

inline constexpr const char* simulated_mark = "SIMULATED VOTES";

/// The text of a title or caption, with the mark before it when any vote is not a person's.
inline std::string marked_if_simulated(const ReportContents& contents, const std::string& text) {
    return contents.findings.design.simulated ? std::string(simulated_mark) + " \u00b7 " + text
                                              : text;
}

} // namespace experiment::report
