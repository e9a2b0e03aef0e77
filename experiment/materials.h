// A scene's material, from its name in a study file to what the methods shade with.
#pragma once

#include "protocols/study.h"
#include "renderer/scene.h"

#include <optional>

namespace experiment {

/// The study's own material of the scene's name, else the measured one; nothing when neither knows
/// the name.
/// Own coefficients get the preset of what a thick layer of them reflects, a colour the preset of
/// that very colour.  Manual: docs/materials.md
std::optional<renderer::Material> material_of(const protocols::Study& study,
                                              const protocols::Scene& scene);

} // namespace experiment
