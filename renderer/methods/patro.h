// Diffuse light softened as far as it spreads in the material, channel by channel, and nothing
// more: a reconstruction of [Patro2007], whose text could not be found.  docs/patro.md
#pragma once

#include "renderer/methods/description.h"

namespace renderer::methods {

Description describe_patro();

struct PatroSettings {
    /// What is smoothed over the surface before shading.
    enum class Variant {
        Normals,  ///< a normal of its own for each channel
        Harmonics ///< the irradiance, in three bands
    };
    Variant variant = Variant::Normals;
};

/// Smooths over the subject's mesh with the widths of its medium and scale.
/// Errors: a mesh that cannot be smoothed over, the driver's log.
Expected<std::unique_ptr<Method>> prepare_patro(const PatroSettings& settings,
                                                const Subject& subject);

} // namespace renderer::methods
