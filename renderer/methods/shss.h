// Spherical-harmonics subsurface scattering: thickness toward any light from coefficients kept at
// the vertices.  [SHSS]
#pragma once

#include "renderer/methods/attenuation.h"
#include "renderer/methods/band_plan.h"
#include "renderer/methods/description.h"
#include "renderer/thickness/streams.h"
#include "renderer/thickness/surface_sample.h"

#include <memory>
#include <optional>

namespace renderer::methods {

Description describe_shss();

struct ShssSettings {
    BandSettings bands = {};
    Law law = Law::Physical;
    thickness::ComponentType coefficients = thickness::ComponentType::Float32;
};

/// Keeps the bands of `field` that may be used in vertex buffers.  `sample`, of the same mesh and
/// field, is where a choice of bands is reckoned (methods/band_plan.h).
/// Errors: no field, one of another mesh, or one with fewer bands than asked for; bands outside
/// 1..6.
Expected<std::unique_ptr<Method>>
prepare_shss(const ShssSettings& settings,
             std::shared_ptr<const Surface> surface,
             std::shared_ptr<const thickness::ThicknessField> field,
             std::optional<thickness::SurfaceSample> sample = {});

} // namespace renderer::methods
