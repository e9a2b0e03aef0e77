// Do judges of the same pairs agree?  Kendall's u.  [KendallBabingtonSmith1940]
#pragma once

#include "analysis/vote_matrix.h"

#include <cstdint>
#include <string>

namespace analysis::consistency {

/// Every number but `judges` is NaN, with a reason, where it is not defined.
struct Agreement {
    std::int64_t conditions = 0;
    std::int64_t judges = 0;
    double agreeing_pairs = 0; ///< Sigma: pairs of judges with the same answer, over all pairs
    double u = 0;              ///< 1 when all agree
    double u_min = 0;          ///< when they disagree as much as they can
    double df = 0;
    double chi_squared_corrected = 0; ///< for continuity
    double p_corrected = 0;
    double chi_squared = 0;
    double p = 0;
    double df_many = 0; ///< the form for many judges
    double chi_squared_many = 0;
    double p_many = 0;
    double p_exact = 0; ///< NaN where the exact law takes too long
    std::string reason;
};

/// `matrix` pools one answer per judge and pair.  Undefined when incomplete, with ties, or for
/// fewer than two judges; the chi-squared tests need more than two.
Agreement agreement(const VoteMatrix& matrix);

} // namespace analysis::consistency
