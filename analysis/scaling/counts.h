// What a choice model reads: how often one condition was chosen over another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace analysis::scaling {

/// Votes of t conditions, row-major t x t: wins[i t + j] is how often i was chosen over j,
/// whichever side they were on.  The diagonal is ignored.
struct WinCounts {
    std::size_t conditions = 0;
    std::span<const std::int64_t> wins;

    std::int64_t operator()(std::size_t i, std::size_t j) const { return wins[i * conditions + j]; }
};

/// The same with the order kept: element (i, j) counts the trials that showed i first (left) and j
/// second (right).  `tied` may be empty: no ties.
struct OrderedCounts {
    std::size_t conditions = 0;
    std::span<const std::int64_t> first_chosen;
    std::span<const std::int64_t> second_chosen;
    std::span<const std::int64_t> tied;
};

} // namespace analysis::scaling
