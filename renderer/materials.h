// Measured translucent materials by name.  [Jensen2001]
#pragma once

#include "renderer/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace renderer {

/// The names of all measured materials, in alphabetical order.
std::vector<std::string> measured_names();

/// Reduced scattering and absorption of a measured material; nothing for an unknown name.
std::optional<Medium> measured_medium(std::string_view name);

/// The medium with the coefficients every shading method draws it with (an artist's preset, the
/// same for all methods).  With R the diffuse reflectance of a thick layer, per channel:
///   diffuse k_di = R/2 and scatter k_sc = R/2: facing the light, the two make the radiance R I_p
///   that a Lambert surface of that reflectance has;
///   ambient k_am = 5 % of k_di; white specular k_sp = 0.04 with exponent q = 32.
std::optional<Material> measured_material(std::string_view name);

} // namespace renderer
