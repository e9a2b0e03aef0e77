// Exact laws of the classical statistics when every answer is a coin's.
// [KendallBabingtonSmith1940], [David1988]
#pragma once

#include <cstdint>
#include <optional>

namespace analysis::consistency {

/// P(no more than `triads` circular triads in `rounds` complete rounds of `conditions`).  Exact up
/// to 7 conditions, by convolution of the enumerated counts; beyond, chi-squared for one round and
/// the normal approximation for more.  NaN for fewer than 3 conditions or no round.
double triads_p(std::int64_t triads, std::int64_t rounds, std::int64_t conditions);

/// P(range of the vote totals >= `range`) with `votes` on every pair of `conditions`.  Nothing
/// beyond 4 conditions or 20 votes a pair, where it takes long.
std::optional<double>
range_p_exact(std::int64_t range, std::int64_t votes, std::int64_t conditions);

/// P(the longest run of one side in `answers` is `length` or longer).
double longest_run_p(std::int64_t length, std::int64_t answers);

} // namespace analysis::consistency
