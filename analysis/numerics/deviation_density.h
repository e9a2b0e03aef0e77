// The density of the logarithm of a standard deviation, which studentized statistics are averaged
// over.
#pragma once

namespace analysis::numerics {

// For s = e^u, the standard deviation of normals of variance 1 on nu degrees of freedom,
//   density of u = exp(log_deviation_scale(nu) + nu deviation_exponent(u)).

/// nu > 0, any real number.
long double log_deviation_scale(long double nu);

/// u - expm1(2u) / 2, which is -(u^2 + 2 u^3 / 3 + ...).
long double deviation_exponent(long double u);

} // namespace analysis::numerics
