// What is lost when only the first bands of a thickness field are used.
#pragma once

#include "renderer/thickness/thickness_field.h"

#include <cstddef>

namespace renderer::thickness {

/// Root mean square, over all directions, of traced minus reconstructed thickness at vertex `v`
/// when the first `bands` bands are used.  Model units.  Exact up to the quadrature:
/// rms^2 = (integral of d^2 - sum of c_i^2) / 4 pi.
/// Errors: EXPECTS 1 <= bands <= field.bands and a vertex there is.
double truncation_rms(const ThicknessField& field, std::size_t v, int bands);

/// The part of the integral of d^2, over all directions and vertices, that `bands` bands hold;
/// 0..1. Thin shells keep little: below 0.6 at the full number of bands their glow is mostly
/// invented.
double energy_kept(const ThicknessField& field, int bands);

} // namespace renderer::thickness
