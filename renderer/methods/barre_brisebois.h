// Translucency from a baked local thickness and a lobe around the light's way on: cheap, and the
// same thickness wherever the light stands.  [BarreBrisebois2011]
#pragma once

#include "renderer/geometry/mesh.h"
#include "renderer/methods/description.h"
#include "renderer/shading/attenuation.h"

namespace renderer::methods {

Description describe_barre_brisebois();

/// ((V . -(L + N distortion))^power scale + ambient) times what passes the local thickness.  A thin
/// part right before the light transmits scale + ambient = 1, as under every other method.
struct BarreBriseboisSettings {
    double distortion = 0.2; ///< how far the normal bends the light, 0..1
    double power = 4;        ///< how narrow the lobe is, 1..64
    double scale = 0.9;
    double ambient = 0.1; ///< what comes through toward every side
    shading::Law law = shading::Law::Physical;
};

/// Bakes the local thickness of `mesh`, the surface's own, from `field`; `mm_per_unit` is the
/// placement's scale.
/// Errors: a field of another mesh, the paper's law without a positive D_n.
Expected<std::unique_ptr<Method>>
prepare_barre_brisebois(const BarreBriseboisSettings& settings,
                        std::shared_ptr<const shading::Surface> surface,
                        const geometry::Mesh& mesh,
                        const thickness::ThicknessField& field,
                        double mm_per_unit);

} // namespace renderer::methods
