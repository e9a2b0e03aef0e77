// An opaque picture as code values: what files exchange and displays are sent.
#pragma once

#include "renderer/imaging/linear_image.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace renderer::imaging {

/// sRGB code values, row-major, top row first, red green blue interleaved.
struct EncodedImage {
    int width = 0, height = 0;
    int bits = 8;                     ///< 8 or 16 per channel
    std::vector<std::uint16_t> codes; ///< 3 width height of them, 0..2^bits - 1
};

/// The light a picture's pixel stands for.
LinearRgb light_at(const EncodedImage& image, std::size_t pixel);

/// The nearest 16-bit codes, without dither: a step is 1/257 of what an 8-bit display can show.
/// `opaque` is a picture over its surround; light above 1 is clipped.
/// Errors: EXPECTS on sizes and NaN.
EncodedImage encode_16bit(const LinearImage& opaque);

/// 8-bit codes with ordered dither: a fixed tile of 8 x 8 thresholds, the same for every picture
/// and channel, so that pictures differ only where their light does.  Values that are codes
/// already (a grey surround) stay as they are.
/// Errors: EXPECTS on sizes and NaN.
/// Source: [Bayer1973]
EncodedImage encode_8bit(const LinearImage& opaque);

} // namespace renderer::imaging
