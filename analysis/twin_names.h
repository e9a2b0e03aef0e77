// Names that a person reads as one.
#pragma once

#include "analysis/vote_table.h"

#include <string>

namespace analysis {

/// "" or a sentence that names two of `names` which differ only in blanks around them: "b" and
/// " b" would be two, and no table would show it.  `what` they are called: "conditions".
std::string twins_but_for_blanks(const Dictionary& names, const std::string& what);

} // namespace analysis
