// From light to code values and back: the exact sRGB curve, and luminance.  Conventions:
// docs/conventions.md#colour
#pragma once

#include "renderer/units.h"

#include <cstdint>

namespace renderer::imaging {

/// The sRGB curve of one channel, 0..1 to 0..1; light above 1 or below 0 is clipped.
/// Errors: EXPECTS a number, not NaN.
/// Source: [IEC61966-2-1]; inverse: `linear_from_srgb`.
double srgb_from_linear(double light);

/// The inverse curve, 0..1 to 0..1.
/// Errors: EXPECTS a value in 0..1.
double linear_from_srgb(double encoded);

EncodedRgb encode(LinearRgb light);
LinearRgb decode(EncodedRgb encoded);

/// The nearest code value of an encoded channel in 0..1 (EXPECTS), halves upward.
std::uint8_t code_8bit(double encoded);
std::uint16_t code_16bit(double encoded);

/// Rec. 709 luminance of linear light; reference white is 1.
double luminance(LinearRgb light);

} // namespace renderer::imaging
