// What a reader must be told beside the numbers, in plain words.
#pragma once

#include "analysis/findings.h"

namespace analysis {

/// Appends the sentences that `findings`, otherwise finished, calls for.
void append_notes(Findings& findings, const VoteTable& table);

} // namespace analysis
