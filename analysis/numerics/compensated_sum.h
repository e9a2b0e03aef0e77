// Sums that keep their digits: Neumaier's compensated summation.
#pragma once

#include <span>

namespace analysis::numerics {

/// Sum of `values`, wrong by at most a few ulp of the result plus n eps^2 of the sum of magnitudes.
double compensated_sum(std::span<const double> values);

} // namespace analysis::numerics
