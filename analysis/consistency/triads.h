// Circular triads: does one observer contradict himself within a round? [KendallBabingtonSmith1940]
#pragma once

#include "analysis/vote_matrix.h"

#include <cstdint>
#include <optional>

namespace analysis::consistency {

/// Most circular triads that `conditions` can form.
std::int64_t most_triads(std::int64_t conditions);

/// Mean and variance of the number of triads when every answer is a coin's.
double expected_triads(std::int64_t conditions);
double triads_variance(std::int64_t conditions);

/// Circular triads of one round: every pair answered once.  A tie makes no triad circular.
/// Nothing unless the round is complete with one answer per pair.
std::optional<std::int64_t> circular_triads(const VoteMatrix& round);

/// 1 - triads / most: 1 is free of contradiction, NaN for two conditions.
double zeta(std::int64_t triads, std::int64_t conditions);

} // namespace analysis::consistency
