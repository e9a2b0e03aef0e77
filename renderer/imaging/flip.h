// FLIP: how different two pictures look when one flips between them, 0..1 at every pixel.
//
// Colours are blurred as the eye does at the viewing distance and compared in a space of even
// steps; edges and points are compared too, and raise the colour's difference where they differ.
// [Andersson2020]; for light beyond the display's range, over a series of exposures
// [Andersson2021].
#pragma once

#include "renderer/imaging/linear_image.h"
#include "renderer/imaging/plane.h"

namespace renderer::imaging {

/// 0.7 m from a display 0.7 m and 3840 pixels wide: the published default.
inline constexpr double default_pixels_per_degree = 67.0206432765;

/// Errors: EXPECTS pictures of one size, and finite light; what is beyond 0..1 is clipped, as a
/// display does.
Plane ldr_flip(const LinearImage& test, const LinearImage& reference, double pixels_per_degree);

/// Exposures in stops: light is multiplied by 2^stop before the tone mapper.
struct ExposureRange {
    double first = 0, last = 0;
    int count = 2;
};

/// From where the brightest pixel of the reference reaches 0.85 of the tone mapper's range to where
/// its median does.
/// Errors: EXPECTS a reference with a pixel of positive light.
ExposureRange exposure_range(const LinearImage& reference);

/// The tone mapper of HDR-FLIP, a rational fit to the ACES curve; clipped to 0..1.
double tone_mapped(double light);

/// At every pixel the greatest FLIP over the exposures.
Plane hdr_flip(const LinearImage& test,
               const LinearImage& reference,
               double pixels_per_degree,
               const ExposureRange& exposures);

} // namespace renderer::imaging
