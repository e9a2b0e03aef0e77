// Classical tests on vote totals of a complete design: David's equality test and the range test.
// They treat votes as independent, so they speak of these observers only.
// [David1988], [SetyawanLagendijk2004]
#pragma once

#include "analysis/vote_matrix.h"

#include <cstdint>
#include <vector>

namespace analysis::consistency {

struct EqualityTest {
    std::int64_t conditions = 0;
    std::int64_t votes_per_pair = 0;
    double d = 0;
    double df = 0;
    double p = 0;
};

/// EXPECTS a complete matrix of at least two conditions.
EqualityTest david_equality(const VoteMatrix& matrix);

struct RangePairVerdict {
    std::size_t first = 0;
    std::size_t second = 0;
    double difference = 0; ///< votes of first less votes of second
    bool significant_005 = false;
    bool significant_001 = false;
};

struct VoteRangeTest {
    std::int64_t conditions = 0;
    std::int64_t votes_per_pair = 0;
    double w_005 = 0, w_001 = 0; ///< upper points of the range of as many normals
    double real_range_005 = 0, real_range_001 = 0;
    double critical_range_005 = 0, critical_range_001 = 0; ///< votes: the next integer
    /// P(a range so large under equality), exactly: the true level; NaN where it takes too long.
    double exact_level_005 = 0, exact_level_001 = 0;
    std::vector<RangePairVerdict> pairs;
};

/// EXPECTS a complete matrix of at least two conditions.
VoteRangeTest range_test(const VoteMatrix& matrix);

} // namespace analysis::consistency
