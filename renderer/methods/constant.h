// Phong's model and light through the same thickness everywhere: the floor of any translucency, in
// looks and in cost.
#pragma once

#include "renderer/methods/description.h"
#include "renderer/shading/attenuation.h"

namespace renderer::methods {

Description describe_constant();

struct ConstantSettings {
    double thickness_mm = 10;
    shading::Law law = shading::Law::Physical;
};

/// Errors: the paper's law without a field that has a D_n; EXPECTS a thickness of 0 or more.
Expected<std::unique_ptr<Method>> prepare_constant(const ConstantSettings& settings,
                                                   std::shared_ptr<const shading::Surface> surface,
                                                   const thickness::ThicknessField* field);

} // namespace renderer::methods
