// All methods there are, by their names in study files.
#pragma once

#include "renderer/methods/description.h"

#include <memory>
#include <span>
#include <string_view>

namespace renderer::methods {

/// In the order people read them: the study's methods, their rivals, the baselines.
std::span<const Description> catalogue();

/// What the others are measured by: the reflection model without any translucency, and the shared
/// law with nothing left out of the thickness.
inline constexpr std::string_view bare_method = "phong", exact_method = "traced";

/// Nothing for a name that no method has.
const Description* find_method(std::string_view name);

/// The dials of a method there is, presets in the place of what was not given.
/// Errors: an unknown dial, a value it cannot take, two that do not go together.
tl::expected<Dials, DialProblem> complete_for(std::string_view name, const Dials& given);

/// Makes a method ready to draw the subject; dials that are not given have their presets.
/// Needs a current OpenGL 4.5 context.
/// Errors: an unknown method or dial, values out of range, what the method cannot do without, the
/// driver's refusals.
Expected<std::unique_ptr<Method>>
prepare_method(std::string_view name, const Dials& dials, const Subject& subject);

} // namespace renderer::methods
