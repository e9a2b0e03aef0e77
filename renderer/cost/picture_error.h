// How far a picture is from another, relative to its light; and the thickness that a picture tells.
#pragma once

#include "renderer/expected.h"
#include "renderer/imaging/linear_image.h"
#include "renderer/methods/method.h"
#include "renderer/scene.h"
#include "renderer/shading/attenuation.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace renderer::cost {

/// Root of the sum of squared differences over the root of the sum of squares of `truth`, over the
/// pixels of the mask and the three channels: 0 for equal pictures, 1 for a black one.
/// Errors: EXPECTS pictures of one size and a mask inside them.  NaN when a pixel is no number or
/// the truth is black.
double relative_rms(const imaging::LinearImage& test,
                    const imaging::LinearImage& truth,
                    std::span<const std::size_t> mask);

/// The same of single numbers.
double relative_rms(std::span<const double> test, std::span<const double> truth);

/// The same, where it is a number.
/// Errors: pixels that are none, and how many; a truth that is black.
Expected<double> relative_error(const imaging::LinearImage& test,
                                const imaging::LinearImage& truth,
                                std::span<const std::size_t> mask);

/// Thickness toward the light at every pixel that the body covers, row by row, else nothing: the
/// picture of the scattered light alone, through the inverse of the law.  NaN where the picture is.
/// In units of 1/sigma_tr of the clearest channel (physical law), or of D_n (the paper's, where it
/// ends at 1). `method` scatters by thickness (methods::Description). Errors: those of
/// `render_picture`; a medium that absorbs nothing under the physical law, for then no picture
/// tells a thickness.
Expected<std::vector<std::optional<double>>>
seen_thickness(methods::Method& method, shading::Law law, Scene scene, int width, int height);

} // namespace renderer::cost
