// Thickness from depth maps: how far a point lies behind what its light meets first.  [Green2004]
// Right for convex bodies; air inside the silhouette counts as material, blurred or not.  Peeling
// the surfaces apart repairs that.
#pragma once

#include "renderer/methods/description.h"
#include "renderer/shading/attenuation.h"
#include "renderer/units.h"

#include <optional>
#include <variant>

namespace renderer::methods {

Description describe_green();
Description describe_green_blur();
Description describe_green_peel();

/// The first surface as the map has it.
struct NearestMap {};

/// The first surface, blurred by a Gaussian.  Far lights only: on a map of angles no width in mm is
/// the same everywhere.
struct BlurredMap {
    /// Its standard deviation; nothing: 1/sigma_tr of the mean channel, at most 5 % of the
    /// diameter.
    std::optional<Millimetres> deviation;
};

/// The nearest `layers` surfaces: what lies inside the material is summed.
struct PeeledMap {
    int layers = 8;
};

struct GreenSettings {
    int depth_map = 2048; ///< texels along its edge
    shading::Law law = shading::Law::Physical;
    std::variant<NearestMap, BlurredMap, PeeledMap> map = {};
};

/// `field` gives D_n to the paper's law and may be missing under the physical one.
/// Errors: a depth map of less than 1 texel or beyond the device's textures.
Expected<std::unique_ptr<Method>> prepare_green(const GreenSettings& settings,
                                                std::shared_ptr<const shading::Surface> surface,
                                                const thickness::ThicknessField* field);

} // namespace renderer::methods
