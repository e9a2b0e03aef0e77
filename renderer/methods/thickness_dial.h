// Which length counts, as a dial that several methods have.
#pragma once

#include "renderer/methods/dials.h"
#include "renderer/thickness/thickness_field.h"

namespace renderer::methods {

/// The dial "thickness".
Dial thickness_dial();
thickness::Kind thickness_kind(const Dials& dials);

} // namespace renderer::methods
