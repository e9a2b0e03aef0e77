// How much of the scattered light passes a thickness of material: one law for every method that
// knows a thickness, so that only the thickness differs between them.
#pragma once

#include "renderer/expected.h"
#include "renderer/thickness/thickness_field.h"

namespace renderer::shading {

enum class Law {
    Paper,   ///< 1 - clamp(d/D_n, 0, 1), the same in every channel  [SHSS, eq. 3]
    Physical ///< exp(-sigma_tr d), per channel
};

/// The law, and the paper's D_n in model units (unused by the physical law).
struct Attenuation {
    Law law = Law::Physical;
    double d_n = 1;
};

/// Takes D_n from the field.  Errors: the paper's law without a field or without a positive D_n.
Expected<Attenuation> attenuation_for(Law law, const thickness::ThicknessField* field);

} // namespace renderer::shading
