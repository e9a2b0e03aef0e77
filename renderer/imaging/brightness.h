// Equal brightness for pictures that are to be compared: one gain per picture, one target for all.
//
// Compared are luminance means over the pixels the object covers wholly; colour is left as it is,
// for it is part of what people judge.
#pragma once

#include "renderer/expected.h"
#include "renderer/imaging/encoded_image.h"
#include "renderer/imaging/linear_image.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace renderer::imaging {

/// Indices of the pixels with coverage >= 0.999, in rising order.
std::vector<std::size_t> covered_pixels(std::span<const float> coverage);

/// Mean Rec. 709 luminance over the pixels of `mask` (EXPECTS: not empty, inside the picture).
double mean_luminance(const LinearImage& image, std::span<const std::size_t> mask);
double mean_luminance(const EncodedImage& image, std::span<const std::size_t> mask);

struct NamedImage {
    std::string_view name; ///< the condition's, for messages
    std::reference_wrapper<const LinearImage> image;
};

/// What was done to one picture; means are luminances, linear, 1 = reference white.
struct BrightnessMatch {
    double mean_before = 0;
    double gain = 1;          ///< one factor for all channels
    double target = 0;        ///< the same for all pictures that were matched together
    double clipped_share = 0; ///< of the mask's pixels, those with a channel above 1 after the gain
    double mean_after = 0;    ///< with what is above 1 clipped, as it will be shown
};

/// Gains that bring every picture's mean over `mask` to one target: `reference_mean` where there is
/// one, else the geometric mean of the pictures' own.  While any picture would clip more than 0.1 %
/// of its mask, the target is lowered for all, by factors of 0.95.
/// Errors: an empty mask; a pixel of the mask that is negative or not a number; a black picture
///         (mean < 1e-4).  EXPECTS pictures of one size.
Expected<std::vector<BrightnessMatch>> match_brightness(std::span<const NamedImage> pictures,
                                                        std::span<const std::size_t> mask,
                                                        std::optional<double> reference_mean = {});

/// The picture, its light multiplied by `gain`, over a uniform grey of 8-bit sRGB code
/// `surround_code` (0..255), blended in linear light: opaque, coverage 1 everywhere.
LinearImage composite_over_grey(const LinearImage& image, double gain, int surround_code);

/// The mean luminance of an encoded picture over `mask`, if it is within 0.2 % of `target`.
/// Errors: names the picture and both means.
Expected<double> check_encoded_mean(std::string_view name,
                                    const EncodedImage& image,
                                    std::span<const std::size_t> mask,
                                    double target);

} // namespace renderer::imaging
