// Spherical-harmonics subsurface scattering: thickness toward any light from coefficients kept at
// the vertices.  [SHSS]
#pragma once

#include "renderer/methods/description.h"
#include "renderer/reconstruction/band_plan.h"
#include "renderer/shading/attenuation.h"
#include "renderer/thickness/streams.h"
#include "renderer/thickness/surface_sample.h"

#include <memory>
#include <optional>

namespace renderer::methods {

Description describe_shss();

struct ShssSettings {
    reconstruction::BandSettings bands = {};
    shading::Law law = shading::Law::Physical;
    thickness::ComponentType coefficients = thickness::ComponentType::Float32;
};

/// Keeps the bands of `field` that may be used in vertex buffers.  `sample`, of the same mesh and
/// field, is where a choice of bands is reckoned (reconstruction/band_plan.h).
/// Errors: no field, one of another mesh, or one with fewer bands than asked for; bands outside
/// 1..6.
Expected<std::unique_ptr<Method>>
prepare_shss(const ShssSettings& settings,
             std::shared_ptr<const shading::Surface> surface,
             std::shared_ptr<const thickness::ThicknessField> field,
             std::optional<thickness::SurfaceSample> sample = {});

} // namespace renderer::methods
