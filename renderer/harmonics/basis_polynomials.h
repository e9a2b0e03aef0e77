// The part of spherical harmonics that depends on latitude, as polynomials.
#pragma once

#include <span>

namespace renderer::harmonics {

/// Constants of the polynomials q(2z^2 - 1) with which
/// y(l, +-m) = q(2z^2 - 1) z^p (C_m, S_m), C_m + i S_m = (x + iy)^m, p = (l - m) mod 2: for every
/// order m, for p = 0 and 1, for l = m + p, m + p + 2, ... below `bands`, the (l - m - p)/2 + 1
/// constants from the highest power on.  T is float or double; each is rounded once.
/// The constants grow as (1 + sqrt 2)^degree, 4 to 8 of them to ten bands: beyond that recurrences
/// lose less.
/// Errors: EXPECTS 1 <= bands <= most_unrolled_bands.
template <class T>
std::span<const T> polynomial_constants(int bands);

extern template std::span<const float> polynomial_constants<float>(int bands);
extern template std::span<const double> polynomial_constants<double>(int bands);

} // namespace renderer::harmonics
