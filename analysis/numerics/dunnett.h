// The largest of several t's that share a control and a standard deviation.  [Dunnett1955]
#pragma once

#include "analysis/numerics/distributions.h"

#include <span>

namespace analysis::numerics {

/// P(max |T_i| >= c) under equality, two-sided.  `loading` has, for every treatment,
/// sqrt(n_i / (n_i + n_control)): T_i and T_j correlate by the product of theirs (1/2 for equal
/// groups).  `df` > 0, any real number, or infinite.  Relative error below 1e-13.  NaN in, NaN out.
/// Errors: EXPECTS at least one loading, each above 0 and below 1.
Tail dunnett_upper_tail(double c, std::span<const double> loading, double df);

/// c with that probability, 0 < p < 1.
double dunnett_quantile(double p, std::span<const double> loading, double df);

} // namespace analysis::numerics
