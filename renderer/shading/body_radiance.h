// Drawing a body whose vertices know what leaves them: what methods share that work it out
// beforehand.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/buffer.h"
#include "renderer/scene.h"
#include "renderer/shading/shading.h"

#include <glm/vec3.hpp>

#include <memory>
#include <span>
#include <vector>

namespace renderer::shading {

/// Inputs behind position and normal are free from here on.
inline constexpr unsigned radiance_location = 2;

/// The radiance at the vertices, plus ambient and specular light of the shared model.
/// Inputs: three floats from `radiance_location` on, one for each channel.
Expected<SurfaceShader> body_radiance_shader(std::shared_ptr<const Surface> surface);

/// A light as the body meets it: from one direction, alike everywhere.
struct IncidentLight {
    glm::dvec3 to_light;   ///< unit, model axes
    glm::dvec3 irradiance; ///< perpendicular irradiance E = pi I_p, per channel
};

/// All lights of a scene.  A near light counts as a far one toward where it stands, as strong as it
/// is at the body's centre.
/// Errors: EXPECTS what `light_setup` checks.
std::vector<IncidentLight> incident_lights(const Scene& scene, const Surface& surface);

/// Millimetres to a model unit; under an uneven scaling the mean.
double mm_per_unit(const Placement& placement);

} // namespace renderer::shading
