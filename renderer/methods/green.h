// Thickness from a depth map: how far a point lies behind the first surface its light meets.
// [Green2004]  Right for convex bodies; air inside the silhouette counts as material.
#pragma once

#include "renderer/methods/attenuation.h"
#include "renderer/methods/description.h"

namespace renderer::methods {

Description describe_green();

struct GreenSettings {
    int depth_map = 2048; ///< texels along its edge
    Law law = Law::Physical;
};

/// `field` gives D_n to the paper's law and may be missing under the physical one.
/// Errors: a depth map of less than 1 texel or beyond the device's textures.
Expected<std::unique_ptr<Method>> prepare_green(const GreenSettings& settings,
                                                std::shared_ptr<const Surface> surface,
                                                const thickness::ThicknessField* field);

} // namespace renderer::methods
