// Dials that several methods have, and what they ask the subject for.
#pragma once

#include "renderer/expected.h"
#include "renderer/methods/description.h"
#include "renderer/shading/attenuation.h"
#include "renderer/thickness/thickness_field.h"

#include <memory>

namespace renderer::methods {

/// The dial "law".
Dial law_dial();
shading::Law law_of(const Dials& dials);

/// The field whose D_n the paper's law divides by, for methods that find their thickness elsewhere;
/// none under the physical law.
Expected<std::shared_ptr<const thickness::ThicknessField>> field_with_d_n(shading::Law law,
                                                                          const Subject& subject);

/// The dial "thickness": which length counts.
Dial thickness_dial();
thickness::Kind thickness_kind(const Dials& dials);

/// The dial "depth_map": texels along an edge.
Dial depth_map_dial();

} // namespace renderer::methods
