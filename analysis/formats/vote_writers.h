// Votes as other programs read them; `read_vote_file` reads each of these again.
#pragma once

#include "analysis/vote_table.h"

#include <string>

namespace analysis::formats {

/// A row per vote: `observer,session_id,<scene factors>,condition_A,condition_B,is_A_selected`, 1
/// for A, 0 for B, 0.5 for a tie.  A was on the left, which the form does not say; no times.
std::string pwcmp_csv(const VoteTable& table);

/// Counts of every observer, session and scene: `observer,session,<scene factors>,player1,player2,
/// win1,win2`, and `ties` where there are any.  No sides, no times.
std::string pair_counts_csv(const VoteTable& table);

/// A row per observer, session and scene, a column `A:B` per pair in the order 1:2, 1:3, 2:3, 1:4:
/// 1 for the first, -1 for the second, 0 undecided, NA where it was not asked.  No sides, no times.
/// Errors: a question that was answered twice in a session; a condition with a colon in its name.
Expected<std::string> paired_comparison_csv(const VoteTable& table);

} // namespace analysis::formats
