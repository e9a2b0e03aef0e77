// How far a picture is from its reference, in the measures people use, over the object's pixels.
#pragma once

#include "renderer/expected.h"
#include "renderer/imaging/flip.h"
#include "renderer/imaging/linear_image.h"
#include "renderer/imaging/plane.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace renderer::imaging {

/// Measures between two pictures, over a mask.  Linear: of light, red, green and blue alike.
/// Encoded: of sRGB values in 0..1, as shown.
struct ImageErrors {
    double rmse = 0;    ///< linear
    double mae = 0;     ///< linear
    double rel_mse = 0; ///< linear: mean of (x - y)^2 / (y^2 + 0.01), y the reference
    double psnr = 0;    ///< encoded, decibels; infinite for equal pictures
    double ssim = 0;    ///< encoded brightness: 11 x 11 Gaussian of 1.5, K 0.01 and 0.03 [Wang2004]
    double ldr_flip = 0;     ///< encoded, mean (renderer/imaging/flip.h)
    double hdr_flip = 0;     ///< linear, mean
    ExposureRange exposures; ///< of HDR-FLIP
};

/// Both as they are, or the picture scaled to the reference's brightness first.
enum class Brightness { Raw, Equalised };

struct ErrorSettings {
    double pixels_per_degree = default_pixels_per_degree;
    Brightness brightness = Brightness::Raw;
};

/// Measures `test` against `reference` over `mask`, pixel indices in rising order.  Filters see the
/// mask's bounding box; averages are over the mask.
/// Errors: sizes that differ; an empty mask; a pixel that is not finite, named; a black picture.
Expected<ImageErrors> image_errors(const LinearImage& test,
                                   const LinearImage& reference,
                                   std::span<const std::size_t> mask,
                                   const ErrorSettings& settings = {});

/// The factor that gives `test` the reference's mean luminance over `mask`.
/// Errors: those of `image_errors`.
Expected<double> brightness_gain(const LinearImage& test,
                                 const LinearImage& reference,
                                 std::span<const std::size_t> mask);

/// The picture with its light multiplied by `gain`.
LinearImage brightened(const LinearImage& image, double gain);

/// Structural similarity of encoded brightness at every pixel, -1..1.
/// Errors: EXPECTS pictures of one size.
Plane ssim_map(const LinearImage& test, const LinearImage& reference);

/// `values` from `low` to `high` as a picture: dark blue through green to yellow, in even steps of
/// lightness.
LinearImage error_map(const Plane& values, double low, double high);

} // namespace renderer::imaging
