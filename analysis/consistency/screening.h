// Observers whose answers look unlike the others', or unlike answers at all.  Everything is
// reported, nobody is left out.  [BT500], [P913], [PerezOrtiz2017], [KendallBabingtonSmith1940]
#pragma once

#include "analysis/vote_table.h"

#include <cstdint>
#include <string>
#include <vector>

namespace analysis::consistency {

// Customary bounds of the flags.
inline constexpr double least_correlation = 0.75;       ///< with the mean of the others
inline constexpr double most_likelihood_distance = 1.5; ///< in quartile ranges below the first
inline constexpr double least_left_out_z = -3;
inline constexpr double guessing_level = 0.05;
inline constexpr double side_z = 3;
inline constexpr double run_level = 0.001;
inline constexpr double most_fast_answers = 0.1;
inline constexpr std::int32_t fast_answer_ms = 300;
inline constexpr std::int32_t slow_answer_ms = 60'000;

/// NaN where it is not defined.
struct ObserverScreening {
    std::string observer;
    // BT.500's, on votes for each condition in each scene; needs complete observers.
    std::int64_t above = 0, below = 0; ///< P and Q
    std::int64_t presentations = 0;    ///< J; 0 when not computed
    bool rejected_by_bt500 = false;
    // Correlation of those votes with the mean of the others.
    double pearson = 0, spearman = 0;
    // Thurstone's scale of the others.
    double log10_likelihood_per_vote = 0;
    double likelihood_distance = 0; ///< quartile ranges below the first quartile; 0 above it
    double left_out_z = 0;          ///< Bradley-Terry: of the log-likelihood under the others' fit
    double largest_shift = 0;       ///< of a score in JOD when the observer is left out
    // Circular triads over all complete rounds.
    std::int64_t triads = 0, rounds = 0;
    double triads_p = 0; ///< P(so few or fewer by guessing)
    // Sides.
    std::int64_t left = 0, answers = 0;
    double side_z = 0, side_p = 0;
    std::int64_t longest_run = 0;
    double longest_run_p = 0; ///< over sessions by Bonferroni
    // Time, where it was recorded.
    std::int64_t timed = 0, fast = 0, slow = 0;
    double median_ms = 0;
    std::vector<std::string> flags; ///< what to look at, in words
};

/// One element per observer, in the table's order.
std::vector<ObserverScreening> screen_observers(const VoteTable& table);

} // namespace analysis::consistency
