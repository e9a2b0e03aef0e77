// Subsurface scattering in screen space: the light on the body is blurred along rows, then along
// columns, by a diffusion profile in the material's own size; highlights stay sharp.  What comes
// through is read from depth maps.  [Jimenez2015, Jimenez2010]
#pragma once

#include "renderer/methods/description.h"
#include "renderer/shading/attenuation.h"

namespace renderer::methods {

Description describe_separable();

struct SeparableSettings {
    int taps = 25; ///< samples along a line; odd
    int depth_map = 2048;
    shading::Law law = shading::Law::Physical;
};

/// `field` gives D_n to the paper's law and may be missing under the physical one.  The blur needs
/// the whole body in the viewport: what lies outside is not seen.
/// Errors: those of Green's method.  Drawing throws std::runtime_error where there is no room for
/// two pictures of the viewport's size.
Expected<std::unique_ptr<Method>> prepare_separable(const SeparableSettings& settings,
                                                    std::shared_ptr<const shading::Surface> surface,
                                                    const thickness::ThicknessField* field);

} // namespace renderer::methods
