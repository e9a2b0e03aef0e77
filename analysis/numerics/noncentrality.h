// Which noncentral F would have shown what was seen: the road to intervals of effect sizes.
#pragma once

namespace analysis::numerics {

/// lambda >= 0 with P(F >= f | lambda) = `upper_p`, by bracketing; 0 when even lambda 0 makes f
/// that likely.  NaN for f that is not finite.  Relative error 1e-12.
/// Errors: EXPECTS on df1, df2 (> 0, finite) and 0 < upper_p < 1.
double noncentrality(double f, double df1, double df2, double upper_p);

} // namespace analysis::numerics
