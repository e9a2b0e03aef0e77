// One-way analysis of variance whose sums of squares are exact integers until the last division.
#pragma once

#include "analysis/numerics/decimal.h"
#include "analysis/numerics/distributions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace analysis::numerics {

/// Sums of squares leave the range of a double long before F does: then they are 0 or infinite and
/// F is still right.  F is infinite when only the variation within is exactly 0, NaN when both are.
struct OneWaySums {
    std::vector<double> mean; ///< of each group, in the unit of the data
    std::int64_t values = 0;
    double ss_between = 0;
    double df_between = 0;
    double ms_between = 0;
    double ss_within = 0;
    double df_within = 0;
    double ms_within = 0;
    double f = 0;
    Tail p;               ///< upper tail of F; NaN where F is
    double r_squared = 0; ///< ss_between over the total; NaN for constant data
    double residual_sd = 0;
};

/// Variances do not change when a constant is subtracted: the first value is, as an integer of a
/// common unit.  What is left fits 128-bit sums of squares unless the data span more digits than
/// two doubles hold; then 64-bit mantissas and two passes take over.
/// Errors: EXPECTS two groups, none of them empty, and more values than groups.
OneWaySums one_way_exact(std::span<const std::vector<Decimal>> groups);

/// The same of doubles, each taken for exactly the number that it is; EXPECTS them finite.
OneWaySums one_way_exact(std::span<const std::vector<double>> groups);

} // namespace analysis::numerics
