// What every method's shaders share: the uniform block of shading.glsl and how it is filled.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/buffer.h"
#include "renderer/gpu/program.h"
#include "renderer/gpu/vertex_array.h"
#include "renderer/methods/method.h"
#include "renderer/methods/surface.h"
#include "renderer/scene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <memory>
#include <span>

namespace renderer::methods {

/// The block `Shading` of shading.glsl, std140.
struct ShadingBlock {
    glm::mat4 clip_from_object{1};
    glm::mat4 world_from_object{1};
    glm::mat4 world_from_object_normal{1};
    glm::vec4 eye{};      // world
    glm::vec4 to_light{}; // world, unit
    glm::vec4 I_a{};
    glm::vec4 I_p{};
    glm::vec4 k_am{};
    glm::vec4 k_di{};
    glm::vec4 k_sp{}; // w: exponent q
    glm::vec4 k_sc{};
    glm::vec4 sigma_tr{};    // 1/mm
    glm::vec4 attenuation{}; // x: 1 for the paper's law; y: 1/D_n in 1/mm; z: longest chord in mm
};

/// The law, and the paper's D_n in model units (unused by the physical law).
struct Attenuation {
    Law law = Law::Physical;
    double d_n = 1;
};

/// Takes D_n from the field.  Errors: the paper's law without a field or without a positive D_n.
Expected<Attenuation> attenuation_for(Law law, const thickness::ThicknessField* field);

/// The light as the model sees it: lengths along `to_light` in the model are `stretch` times
/// those in the world, exactly for every affine placement.
struct ModelLight {
    glm::dvec3 to_light; ///< unit, model axes
    double stretch;
};

/// v = A^-1 L with A the linear part of the placement; to_light = v/|v|, stretch = |v|.
/// Errors: a light without a direction, a placement that flattens the model.
Expected<ModelLight> model_light(const Scene& scene);

/// A program that shades a surface: what the three methods have in common.
class SurfaceShader {
  public:
    /// `vertex` and `fragment` follow shading.glsl.
    static Expected<SurfaceShader> prepare(std::shared_ptr<const Surface> surface,
                                           const Attenuation& attenuation,
                                           std::span<const gpu::ShaderPart> vertex,
                                           std::span<const gpu::ShaderPart> fragment);

    /// The surface's vertex array, to be fed with what a method adds.
    gpu::VertexArray& vertex_array() { return vertex_array_; }

    const Surface& surface() const { return *surface_; }

    /// Fills the block and draws.
    void draw(const Scene& scene);

  private:
    SurfaceShader(std::shared_ptr<const Surface> surface,
                  const Attenuation& attenuation,
                  gpu::Program program);

    std::shared_ptr<const Surface> surface_;
    Attenuation attenuation_;
    gpu::Program program_;
    gpu::VertexArray vertex_array_;
    gpu::Buffer block_;
};

} // namespace renderer::methods
