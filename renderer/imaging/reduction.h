// A picture made smaller, as a lens would: light is averaged, not code values.
#pragma once

#include "renderer/imaging/encoded_image.h"

namespace renderer::imaging {

/// 8-bit codes of the picture averaged over equal areas in linear light, its longer edge at most
/// `greatest_edge` pixels (>= 1); never enlarged.
/// Errors: EXPECTS on sizes.
EncodedImage reduced(const EncodedImage& image, int greatest_edge);

} // namespace renderer::imaging
