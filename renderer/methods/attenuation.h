// How much of the scattered light passes a thickness of material: one law for every method that
// knows a thickness, so that only the thickness differs between them.
#pragma once

#include "renderer/expected.h"
#include "renderer/methods/description.h"
#include "renderer/thickness/thickness_field.h"

#include <memory>

namespace renderer::methods {

enum class Law {
    Paper,   ///< 1 - clamp(d/D_n, 0, 1), the same in every channel  [SHSS, eq. 3]
    Physical ///< exp(-sigma_tr d), per channel
};

/// The dial "law".
Dial law_dial();
Law law_of(const Dials& dials);

/// The law, and the paper's D_n in model units (unused by the physical law).
struct Attenuation {
    Law law = Law::Physical;
    double d_n = 1;
};

/// Takes D_n from the field.  Errors: the paper's law without a field or without a positive D_n.
Expected<Attenuation> attenuation_for(Law law, const thickness::ThicknessField* field);

/// The field whose D_n the paper's law divides by, for methods that find their thickness elsewhere;
/// none under the physical law.
Expected<std::shared_ptr<const thickness::ThicknessField>> field_with_d_n(Law law,
                                                                          const Subject& subject);

} // namespace renderer::methods
