// Which pairs of conditions were compared, and how often: what scores of an incomplete design stand
// on.
#pragma once

#include "analysis/vote_matrix.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace analysis {

/// Pairs are of condition indices, first < second.
struct PairCoverage {
    std::int64_t pairs = 0;    ///< of conditions
    std::int64_t compared = 0; ///< at least once
    std::int64_t fewest = 0;   ///< comparisons of a compared pair
    std::int64_t most = 0;
    std::pair<std::size_t, std::size_t> rarest{}; ///< a pair with the fewest
    /// Compared pairs without which the conditions would fall apart in two groups.
    std::vector<std::pair<std::size_t, std::size_t>> bridges;
};

PairCoverage pair_coverage(const VoteMatrix& matrix);

/// Sentences on what is thin: pairs compared fewer than 5 times, bridges, and unequal numbers.
std::vector<std::string> coverage_notes(const PairCoverage& coverage,
                                        const std::vector<std::string>& conditions);

} // namespace analysis
