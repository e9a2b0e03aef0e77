// What is drawn: matter, light and camera as values.  Conventions: docs/conventions.md#light
#pragma once

#include "renderer/units.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <variant>
#include <vector>

namespace renderer {

/// A translucent medium.  sigma_s is the reduced scattering coefficient sigma_s' = (1 - g) sigma_s.
struct Medium {
    RgbPerMillimetre sigma_a;
    RgbPerMillimetre sigma_s_reduced;
    double index = 1.3; ///< inside over outside
};

/// Effective transport coefficient sigma_tr = sqrt(3 sigma_a (sigma_a + sigma_s')), per channel.
RgbPerMillimetre effective_transport(const Medium& medium);

/// The Phong model's coefficients k, with the paper's fourth term: light that has come through
/// (`scatter`).
struct Reflectance {
    LinearRgb ambient;
    LinearRgb diffuse;
    LinearRgb specular;
    LinearRgb scatter;
    float shininess = 32; ///< the exponent q
};

struct Material {
    Medium medium;
    Reflectance reflectance;
};

/// Far away: the same direction from everywhere.
struct DirectionalLight {
    glm::dvec3 to_light{0, 0, 1}; ///< unit vector from the surface toward the light, world space
    bool operator==(const DirectionalLight&) const = default;
};

/// Near: what arrives falls with the square of the distance.
struct PointLight {
    glm::dvec3 position{0, 0, 1}; ///< world space, mm
    Millimetres reference{100};   ///< the distance at which its intensity is what it says
    bool operator==(const PointLight&) const = default;
};

/// `intensity` is the paper's I_p: perpendicular irradiance E over pi.
struct Light {
    std::variant<DirectionalLight, PointLight> place;
    LinearRgb intensity{1, 1, 1};
    bool operator==(const Light&) const = default;
};

/// As many lights as one picture may have.
inline constexpr std::size_t most_lights = 8;

struct Camera {
    glm::dmat4 view_from_world{1}; ///< right-handed: x right, y up, looking along -z
    glm::dmat4 clip_from_view{1};  ///< OpenGL's clip space, depth -1..1
};

/// How the model stands in the world.  World units are millimetres.
struct Placement {
    glm::dmat4 world_from_model{1};
    bool operator==(const Placement&) const = default;
};

/// One picture's worth of world around a model.
struct Scene {
    Placement placement;
    Material material;
    std::vector<Light> lights{{}}; ///< 1 to `most_lights`
    LinearRgb ambient{1, 1, 1};    ///< the paper's I_a, from everywhere
    Camera camera;
};

} // namespace renderer
