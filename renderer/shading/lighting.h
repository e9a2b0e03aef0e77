// The scene's lights as shaders and models see them.  Conventions: docs/conventions.md#light
#pragma once

#include "renderer/expected.h"
#include "renderer/scene.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <compare>
#include <string>
#include <vector>

namespace renderer::shading {

/// Number and kind of lights: what a shader is compiled for.
struct LightSetup {
    int count = 1;
    bool with_points = false; ///< whether any of them is a point light
    auto operator<=>(const LightSetup&) const = default;
};

/// Errors: no lights or more than `most_lights`, one without a direction or a place, a placement
/// that flattens the model.
Expected<LightSetup> light_setup(const Scene& scene);

/// `#define`s for shading.glsl.
std::string defines(const LightSetup& setup);

/// What the light that reaches the body depends on: while it stays the same, nothing that depends
/// on light alone has to be computed again.
struct Lighting {
    std::vector<Light> lights;
    Placement placement;
    bool operator==(const Lighting&) const = default;
};

Lighting lighting_of(const Scene& scene);

/// A directional light as the model sees it: lengths along `to_light` in the model are `stretch`
/// times those in the world, exactly for every affine placement.
struct ModelLight {
    glm::dvec3 to_light; ///< unit, model axes
    double stretch;
};

/// v = A^-1 L with A the linear part of the placement; to_light = v/|v|, stretch = |v|.
/// Errors: EXPECTS what `light_setup` checks.
ModelLight model_light(const DirectionalLight& light, const Placement& placement);

/// |A d| <= result |d| for every d: the exact stretch where A scales evenly.
double largest_stretch(const glm::dmat3& A);

/// Of lengths of the whole object: the cube root of the volume's.
double mean_stretch(const glm::dmat3& A);

} // namespace renderer::shading
