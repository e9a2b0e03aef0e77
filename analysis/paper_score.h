// The score of the paper: votes per round, averaged over observers and scenes.
#pragma once

#include "analysis/exact.h"
#include "analysis/vote_table.h"

#include <string>
#include <vector>

namespace analysis {

/// NaN marks what the design does not define.
struct PaperScore {
    std::string condition;
    double total_votes = 0;                        ///< a tie counts one half
    double mean_votes_per_round = 0;               ///< 0..max_per_round
    double max_per_round = 0;                      ///< t - 1
    double mean_votes_per_observer_and_factor = 0; ///< over observers and the first scene factor
    double share = 0;        ///< 0..1: mean over observers of each observer's share
    double share_pooled = 0; ///< 0..1: votes over comparisons; the same in a complete design
    double sd_over_observer_factor_cells = 0; ///< of votes per round
    double sd_over_observers = 0;             ///< of votes per round
    double se_over_observers = 0;
    Fraction exact_share; ///< pooled
    double rank = 0;      ///< 1 is best; equal scores share the middle rank
};

/// One score per condition, in the table's order of conditions.
std::vector<PaperScore> paper_scores(const VoteTable& table);

/// Condition indices, best first; equal scores keep the table's order.
std::vector<std::size_t> ranking(const std::vector<PaperScore>& scores);

} // namespace analysis
