// Precomputed radiance transfer with subsurface scattering.  [Sloan2003]
#pragma once

#include "renderer/methods/description.h"
#include "renderer/transfer/compression.h"
#include "renderer/transfer/transfer_field.h"

#include <memory>

namespace renderer::methods {

Description describe_prt();

/// Draws with the transfer vectors themselves.
/// Errors: a field of another mesh; the driver's log.
Expected<std::unique_ptr<Method>> prepare_prt(std::shared_ptr<const shading::Surface> surface,
                                              const transfer::TransferField& field);

/// Draws with clustered principal components of them.
/// Errors: signals of another mesh, or not of `bands`; more than 4096 representatives, which is
/// what a uniform block holds; more than 15 vectors; the driver's log.
Expected<std::unique_ptr<Method>> prepare_prt(std::shared_ptr<const shading::Surface> surface,
                                              const transfer::CompressedSignals& signals,
                                              int bands);

} // namespace renderer::methods
