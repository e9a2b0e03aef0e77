// Translucent materials: measured ones by name, a person's own coefficients, or a colour asked for.
// Manual: docs/materials.md
#pragma once

#include "renderer/scene.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace renderer {

/// The names of all measured materials, in alphabetical order.
std::vector<std::string> measured_names();

/// Reduced scattering, absorption and index of a measured material; nothing for an unknown name.
/// Source: [Jensen2001, table 1].
std::optional<Medium> measured_medium(std::string_view name);

/// The index-matched medium whose thick layer has about this colour in diffuse light.
/// `colour` is that reflectance, 0..1.  `scattering_distance` (> 0, one per channel) is the length
/// d of normalised diffusion, whose profile is exp(-r/d) + exp(-r/(3d)) over r. EXPECTS both
/// ranges.  The layer's true reflectance is within 0.007 of the colour up to 0.8; above, the fit
/// falls short: colour 0.9 gives 0.870, colour 1 gives 0.926 (absorption never quite ends). Source:
/// [Chiang2016].
Medium medium_of_colour(LinearRgb colour, const std::array<Millimetres, 3>& scattering_distance);

/// The coefficients every shading method draws a material with (an artist's preset, the same for
/// all methods).  With R the `reflectance` of a thick layer, per channel, 0..1:
///   diffuse k_di = R/2 and scatter k_sc = R/2: facing the light, the two make the radiance R I_p
///   that a Lambert surface of that reflectance has;
///   ambient k_am = 5 % of k_di; white specular k_sp = 0.04 with exponent q = 32.
Reflectance preset(LinearRgb reflectance);

/// A medium with the preset of what its thick layer, lit straight down, sends back from inside:
/// `body_reflectance` (renderer/half_space.h) of its reduced albedo and index.
/// EXPECTS coefficients >= 0, not both zero in any channel, and an index >= 1.
Material material_of(const Medium& medium);

/// `material_of` a measured medium; nothing for an unknown name.
std::optional<Material> measured_material(std::string_view name);

} // namespace renderer
