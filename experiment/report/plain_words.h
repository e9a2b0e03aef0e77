// The result in sentences: by which test, at which level, over which units.
#pragma once

#include "experiment/report/contents.h"

#include <string>
#include <vector>

namespace experiment::report {

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& items);

/// What letters mean, as a sentence after another; "" where the ranking has none.
std::string letters_in_words(const ReportContents& contents);

/// What was found, one paragraph per element; plain text, not escaped.
std::vector<std::string> result_in_words(const ReportContents& contents);

/// How the numbers were come by, every choice named; plain text, not escaped.
std::vector<std::string> methods_in_words(const ReportContents& contents);

} // namespace experiment::report
