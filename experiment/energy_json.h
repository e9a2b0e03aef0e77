// What `pairlight reference slab|half-space|sphere|furnace` prints, as JSON.
#pragma once

#include "renderer/reference/energy.h"

#include <string>

namespace experiment {

enum class EnergyShape { Slab, HalfSpace, Sphere, Furnace };

/// {"reflectance": {"estimate", "standard_error"}, "transmittance": {...}, "specular", "seconds",
/// ...}; a sphere and a furnace have "escape", and a sphere in a parallel beam "forward", the part
/// that leaves into the beam's half of all directions.
std::string energy_json(const renderer::reference::EnergyBalance& balance,
                        EnergyShape shape,
                        renderer::reference::Incidence incidence,
                        double seconds);

} // namespace experiment
