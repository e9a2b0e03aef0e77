// How far light flies before it meets matter.
#pragma once

#include <cmath>
#include <limits>

namespace renderer::reference {

/// The distance to the next collision, drawn with `u` in [0, 1): -ln(1 - u) / sigma.  Finite for
/// every such u, 0 for u = 0; infinite where nothing collides.  Exact to rounding for multiples of
/// 2^-53, which all random numbers are: 1 - u is one too.
inline double flight_length(double u, double sigma) {
    return sigma == 0 ? std::numeric_limits<double>::infinity() : -std::log(1 - u) / sigma;
}

} // namespace renderer::reference
