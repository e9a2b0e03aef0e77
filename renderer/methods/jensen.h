// The dipole without anything precomputed but samples: worked out anew whenever a light moves.
// [Jensen2001; JensenBuhler2002]
#pragma once

#include "renderer/diffusion/jensen.h"
#include "renderer/methods/description.h"

#include <memory>

namespace renderer::methods {

Description describe_jensen();

/// `body` is the one that `surface` was made from.
/// Errors: the driver's log.
Expected<std::unique_ptr<Method>> prepare_jensen(std::shared_ptr<const shading::Surface> surface,
                                                 std::unique_ptr<const diffusion::DipoleBody> body);

} // namespace renderer::methods
