// Vote matrices and scores as CSV text, in the forms other tools read.
#pragma once

#include "analysis/vote_table.h"

#include <string>

namespace analysis {

/// `scope,observer,session,<scene factors>,winner,loser,votes` for the usual scopes; a `ties`
/// column follows when there are ties, and a `simulated` column, all 1, when any vote is simulated.
std::string vote_matrices_csv(const VoteTable& table);

/// `scope,observer,session,<scene factors>,method,votes,max_votes,share` for the same scopes; a tie
/// counts one half.  A share without comparisons is empty.  `simulated` follows as above.
std::string scores_csv(const VoteTable& table);

} // namespace analysis
