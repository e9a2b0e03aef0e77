// Filling the shared uniform block from a scene.
#include "renderer/methods/shading.h"

#include "renderer/contract.h"
#include "renderer/methods/shading.glsl.h"
#include "renderer/methods/surface.glsl.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace renderer::methods {

namespace {

glm::vec4 rgb(LinearRgb colour, float w = 0) {
    return {colour.r, colour.g, colour.b, w};
}

ShadingBlock
shading_block(const Scene& scene, const Surface& surface, const Attenuation& attenuation) {
    const auto light = model_light(scene);
    EXPECTS(light.has_value()); // `relight` has said so to the caller
    EXPECTS(scene.material.reflectance.shininess > 0);
    const auto& k = scene.material.reflectance;
    const auto world_from_object = surface.world_from_object(scene.placement);
    const auto world_from_view = glm::inverse(scene.camera.view_from_world);
    const glm::dmat3 linear(scene.placement.world_from_model);
    const auto sigma_tr = effective_transport(scene.material.medium);

    // D_n is a length of the whole object: under an uneven scaling it takes the mean scale.
    const double mean_scale = std::cbrt(std::abs(glm::determinant(linear)));
    const double longest_chord = 2 * surface.model_sphere().radius / light->stretch;
    return {.clip_from_object = glm::mat4(scene.camera.clip_from_view *
                                          scene.camera.view_from_world * world_from_object),
            .world_from_object = glm::mat4(world_from_object),
            .world_from_object_normal = glm::mat4(glm::mat3(glm::transpose(glm::inverse(linear)))),
            .eye = glm::vec4(world_from_view[3]),
            .to_light = glm::vec4(glm::normalize(scene.light.to_light), 0),
            .I_a = rgb(scene.ambient),
            .I_p = rgb(scene.light.intensity),
            .k_am = rgb(k.ambient),
            .k_di = rgb(k.diffuse),
            .k_sp = rgb(k.specular, k.shininess),
            .k_sc = rgb(k.scatter),
            .sigma_tr = glm::vec4(glm::dvec4(sigma_tr.r, sigma_tr.g, sigma_tr.b, 0)),
            .attenuation =
                glm::vec4(glm::dvec4(attenuation.law == Law::Paper ? 1 : 0,
                                     1 / (attenuation.d_n * mean_scale), longest_chord, 0))};
}

std::vector<gpu::ShaderPart> behind(std::initializer_list<gpu::ShaderPart> shared,
                                    std::span<const gpu::ShaderPart> own) {
    std::vector<gpu::ShaderPart> parts(shared);
    parts.insert(parts.end(), own.begin(), own.end());
    return parts;
}

} // namespace

Expected<Attenuation> attenuation_for(Law law, const thickness::ThicknessField* field) {
    if (law == Law::Physical)
        return Attenuation{};
    if (field == nullptr)
        return tl::make_unexpected("the paper's law divides by D_n, expected a thickness field");
    if (!(field->d_n > 0))
        return tl::make_unexpected(
            fmt::format("the thickness field's D_n is {}, expected > 0", field->d_n));
    return Attenuation{Law::Paper, field->d_n};
}

Expected<ModelLight> model_light(const Scene& scene) {
    const auto& L = scene.light.to_light;
    const double length = glm::length(L);
    if (!(length > 0) || !std::isfinite(length))
        return tl::make_unexpected(fmt::format(
            "light direction ({}, {}, {}), expected a vector with a length", L.x, L.y, L.z));
    const glm::dmat3 linear(scene.placement.world_from_model);
    const double volume = glm::determinant(linear);
    if (volume == 0 || !std::isfinite(volume))
        return tl::make_unexpected("the placement flattens the model, expected one that can be "
                                   "undone");
    const auto v = glm::inverse(linear) * (L / length);
    return ModelLight{glm::normalize(v), glm::length(v)};
}

SurfaceShader::SurfaceShader(std::shared_ptr<const Surface> surface,
                             const Attenuation& attenuation,
                             gpu::Program program)
    : surface_(std::move(surface)), attenuation_(attenuation), program_(std::move(program)),
      vertex_array_(surface_->vertex_array()), block_(sizeof(ShadingBlock)) {}

Expected<SurfaceShader> SurfaceShader::prepare(std::shared_ptr<const Surface> surface,
                                               const Attenuation& attenuation,
                                               std::span<const gpu::ShaderPart> vertex,
                                               std::span<const gpu::ShaderPart> fragment) {
    const gpu::ShaderPart shading{"shading.glsl", shading_glsl};
    const gpu::ShaderPart placing{"surface.glsl", surface_glsl};
    auto program =
        gpu::Program::link(behind({shading, placing}, vertex), behind({shading}, fragment));
    if (!program)
        return tl::make_unexpected(program.error());
    return SurfaceShader(std::move(surface), attenuation, std::move(*program));
}

void SurfaceShader::draw(const Scene& scene) {
    block_.replace_by(shading_block(scene, *surface_, attenuation_));
    block_.bind_uniform_block(0);
    program_.use();
    vertex_array_.draw();
}

} // namespace renderer::methods
