// The shared model of reflection and attenuation with thickness traced whenever a light moves: no
// coefficients, no maps, nothing left out.  What the methods that know a thickness come near to.
#pragma once

#include "renderer/methods/description.h"
#include "renderer/methods/method.h"
#include "renderer/shading/attenuation.h"
#include "renderer/shading/surface.h"
#include "renderer/thickness/thickness_field.h"

#include <memory>

namespace renderer::methods {

Description describe_traced();

struct TracedSettings {
    thickness::Kind kind = thickness::Kind::Sum;
    shading::Law law = shading::Law::Physical;
};

/// `field` gives the paper's law its D_n and may be null under the physical one.
/// Errors: a mesh without an inside; those of `attenuation_for`; the driver's.
Expected<std::unique_ptr<Method>> prepare_traced(const TracedSettings& settings,
                                                 std::shared_ptr<const shading::Surface> surface,
                                                 const geometry::Mesh& mesh,
                                                 const thickness::ThicknessField* field);

} // namespace renderer::methods
