// How far light flies before it meets matter.
#pragma once

#include <cmath>
#include <limits>

namespace renderer::reference {

/// The distance to the next collision, drawn with `u` in [0, 1): -ln(1 - u) / sigma.  Finite for
/// every such u, 0 for u = 0; infinite where nothing collides.
inline double flight_length(double u, double sigma) {
    return sigma == 0 ? std::numeric_limits<double>::infinity() : -std::log1p(-u) / sigma;
}

} // namespace renderer::reference
