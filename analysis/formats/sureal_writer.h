// Votes as a data set of sureal, which `read_vote_file` reads again.
#pragma once

#include "analysis/vote_table.h"

#include <string>

namespace analysis::formats {

/// The text of a Python module: `ref_videos`, one for every scene, and `dis_videos`, one for every
/// condition of a scene, numbered from 0.  The winner's `os` has (observer, loser): 1; a tie stands
/// with both as 0.5.  Beside what sureal asks for, `scene`, `condition` and `simulated` keep the
/// names and the mark.  No sides, no sessions, no order, no times.
/// Errors: no votes; a question that one observer answered twice.
Expected<std::string> sureal_script(const VoteTable& table);

} // namespace analysis::formats
