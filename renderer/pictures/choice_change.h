// What a method's own choice changes in the picture, by drawing it without the choice.
#pragma once

#include "renderer/expected.h"
#include "renderer/imaging/linear_image.h"
#include "renderer/methods/method.h"
#include "renderer/scene.h"

#include <optional>

namespace renderer::pictures {

/// Root mean square of the brightness that differs, over the pixels the body covers wholly, in the
/// channel where it is most: what `Method::predicted_change` reckons.  `image` is the method's last
/// picture, of the same scene and samples.  Nothing where there was nothing to reckon.
/// Errors: those of `render_picture`.
Expected<std::optional<double>> measured_change(methods::Method& method,
                                                const Scene& scene,
                                                const imaging::LinearImage& image,
                                                int samples);

} // namespace renderer::pictures
