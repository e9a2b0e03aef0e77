// What the bands of each vertex can amount to at most, in one byte each: a guarantee for every
// vertex and every light where band_choice.h speaks of the mean.
#pragma once

#include "renderer/thickness/thickness_field.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace renderer::thickness {

/// ||c_l||, the length of the 2l+1 coefficients of band l, of every vertex, rounded up.
struct BandNorms {
    int bands = 0;
    std::vector<double> step;       ///< of each band: a byte b stands for b * step[l], model units
    std::vector<std::uint8_t> norm; ///< vertex-major: norm[v * bands + l]
};

BandNorms band_norms(const ThicknessField& field);

/// sqrt((N^2 - n^2) / 4 pi): how much the thickness changes at most, in any direction, when bands
/// n..N-1 with coefficients of length 1 are left out.  1.2927 for 2 of 5, 1.1284 for 3 of 5, 1.3820
/// for 1 of 5.  (Cauchy's inequality with the sum of y_i^2 over a band, (2l+1)/4 pi.)
double dropped_factor(int bands, int available);

/// Thickness of vertex `v` changes by no more than this in any direction when only the first
/// `bands` bands are used.  Model units.
/// Errors: EXPECTS 1 <= bands <= norms.bands and a vertex there is.
double dropped_bound(const BandNorms& norms, std::size_t v, int bands);

} // namespace renderer::thickness
