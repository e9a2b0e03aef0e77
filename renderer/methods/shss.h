// Spherical-harmonics subsurface scattering: thickness toward any light from coefficients kept at
// the vertices.  [SHSS]
#pragma once

#include "renderer/methods/attenuation.h"
#include "renderer/methods/description.h"

namespace renderer::methods {

Description describe_shss();

struct ShssSettings {
    int bands = 5; ///< 1..6; n bands are n^2 coefficients per vertex
    Law law = Law::Physical;
};

/// Keeps the first `settings.bands` bands of `field` in vertex buffers.
/// Errors: no field, one of another mesh, or one with fewer bands than asked for; bands outside
/// 1..6.
Expected<std::unique_ptr<Method>>
prepare_shss(const ShssSettings& settings,
             std::shared_ptr<const Surface> surface,
             std::shared_ptr<const thickness::ThicknessField> field);

} // namespace renderer::methods
