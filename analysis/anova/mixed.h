// One factor within observers and groups of observers between: groups may differ in size.
#pragma once

#include "analysis/anova/f_test.h"
#include "analysis/anova/sphericity.h"

#include <cstdint>
#include <span>

namespace analysis::anova {

struct MixedAnalysis {
    Variation group;       ///< between groups
    Variation group_error; ///< observers within groups
    FTest group_test;
    Variation method_unweighted; ///< type III: every group counts the same
    FTest method_unweighted_test;
    Variation method_weighted; ///< types I and II: every observer counts the same
    FTest method_weighted_test;
    Variation group_x_method;
    FTest group_x_method_test;
    Variation within_error; ///< method x observer within groups
    Sphericity sphericity;  ///< its p-values are of group x method
};

/// `counts` is row-major observers x levels, `divisor` of them make a unit of score; `groups` has a
/// code from 0 per observer.  EXPECTS at least two groups, none empty, and more observers.
MixedAnalysis mixed_of_counts(std::span<const std::int64_t> counts,
                              std::span<const int> groups,
                              std::size_t levels,
                              std::int64_t divisor);

} // namespace analysis::anova
