// Does the method matter, without any assumption about the votes?  Labels are permuted within
// observers.
#pragma once

#include <cstdint>
#include <span>

namespace analysis::anova {

struct Permutation {
    std::int64_t arrangements = 0; ///< looked at, the observed one included
    std::int64_t as_large = 0;     ///< with F as large as the observed one or larger
    bool complete = false;         ///< every arrangement was looked at: p is exact
    double p = 0;
};

/// `counts` is row-major observers x levels, with the same sum for every observer (so that F grows
/// with the squares of the level totals, which are compared as integers).
/// All (levels!)^(observers - 1) arrangements when they are at most 2e6, else `draws` random ones
/// from `seed`.  EXPECTS at least two observers and levels, and draws > 0.
Permutation permute_labels(std::span<const std::int64_t> counts,
                           std::size_t levels,
                           std::uint64_t seed,
                           std::int64_t draws = 9999);

} // namespace analysis::anova
