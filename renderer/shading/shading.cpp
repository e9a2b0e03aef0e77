// Filling the shared uniform block from a scene.
#include "renderer/shading/shading.h"

#include "renderer/contract.h"
#include "renderer/shading/shading.glsl.h"
#include "renderer/shading/surface.glsl.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace renderer::shading {

namespace {

/// The block `Shading` of shading.glsl, std140.
struct ShadingBlock {
    glm::mat4 clip_from_object{1};
    glm::mat4 world_from_object{1};
    glm::mat4 world_from_object_normal{1};
    glm::vec4 eye{}; // world
    glm::vec4 I_a{};
    glm::vec4 k_am{};
    glm::vec4 k_di{};
    glm::vec4 k_sp{}; // w: exponent q
    glm::vec4 k_sc{};
    glm::vec4 sigma_tr{}; // 1/mm
    glm::vec4 law{};      // x: 1 for the paper's; y: 1/D_n in 1/mm; z: longest chord in mm
    std::array<glm::vec4, most_lights> light{};
    std::array<glm::vec4, most_lights> intensity{};
};

glm::vec4 rgb(LinearRgb colour, float w = 0) {
    return {colour.r, colour.g, colour.b, w};
}

void fill_lights(const Scene& scene, ShadingBlock& block) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const auto& [place, intensity] = scene.lights[i];
        if (const auto* far = std::get_if<DirectionalLight>(&place)) {
            block.light[i] = glm::vec4(glm::normalize(far->to_light), 0);
            block.intensity[i] = rgb(intensity);
        } else {
            const auto& near = std::get<PointLight>(place);
            block.light[i] = glm::vec4(near.position, 1);
            const double r = near.reference.value;
            block.intensity[i] = rgb(intensity, static_cast<float>(r * r));
        }
    }
}

ShadingBlock
shading_block(const Scene& scene, const Surface& surface, const Attenuation& attenuation) {
    EXPECTS(scene.material.reflectance.shininess > 0);
    const auto& k = scene.material.reflectance;
    const auto world_from_object = surface.world_from_object(scene.placement);
    const auto world_from_view = glm::inverse(scene.camera.view_from_world);
    const glm::dmat3 linear(scene.placement.world_from_model);
    const auto sigma_tr = effective_transport(scene.material.medium);

    // D_n is a length of the whole object: under an uneven scaling it takes the mean scale.
    const double mean_scale = mean_stretch(linear);
    const double longest_chord = 2 * surface.model_sphere().radius * largest_stretch(linear);
    ShadingBlock block{
        .clip_from_object = glm::mat4(scene.camera.clip_from_view * scene.camera.view_from_world *
                                      world_from_object),
        .world_from_object = glm::mat4(world_from_object),
        .world_from_object_normal = glm::mat4(glm::mat3(glm::transpose(glm::inverse(linear)))),
        .eye = glm::vec4(world_from_view[3]),
        .I_a = rgb(scene.ambient),
        .k_am = rgb(k.ambient),
        .k_di = rgb(k.diffuse),
        .k_sp = rgb(k.specular, k.shininess),
        .k_sc = rgb(k.scatter),
        .sigma_tr = glm::vec4(glm::dvec4(sigma_tr.r, sigma_tr.g, sigma_tr.b, 0)),
        .law = glm::vec4(glm::dvec4(attenuation.law == Law::Paper ? 1 : 0,
                                    1 / (attenuation.d_n * mean_scale), longest_chord, 0))};
    fill_lights(scene, block);
    return block;
}

std::vector<gpu::ShaderPart> behind(std::initializer_list<gpu::ShaderPart> shared,
                                    const std::vector<gpu::ShaderPart>& own) {
    std::vector<gpu::ShaderPart> parts(shared);
    parts.insert(parts.end(), own.begin(), own.end());
    return parts;
}

} // namespace

SurfaceShader::SurfaceShader(std::shared_ptr<const Surface> surface,
                             const Attenuation& attenuation,
                             ShaderSource source)
    : surface_(std::move(surface)), attenuation_(attenuation), source_(std::move(source)),
      vertex_array_(surface_->vertex_array()), block_(sizeof(ShadingBlock)) {}

Expected<SurfaceShader> SurfaceShader::prepare(std::shared_ptr<const Surface> surface,
                                               const Attenuation& attenuation,
                                               ShaderSource source) {
    SurfaceShader shader(std::move(surface), attenuation, std::move(source));
    if (const auto compiled = shader.compile({}); !compiled)
        return tl::make_unexpected(compiled.error());
    return shader;
}

Expected<void> SurfaceShader::compile(const LightSetup& setup) {
    const auto lines = defines(setup) + source_.defines;
    const gpu::ShaderPart head{"defines", lines}, shading{"shading.glsl", shading_glsl},
        placing{"surface.glsl", surface_glsl};
    auto program = gpu::Program::link(behind({head, shading, placing}, source_.vertex),
                                      behind({head, shading}, source_.fragment));
    if (!program)
        return tl::make_unexpected(program.error());
    programs_.emplace(setup, std::move(*program));
    return {};
}

Expected<void> SurfaceShader::adapt(const Scene& scene) {
    const auto setup = light_setup(scene);
    if (!setup)
        return tl::make_unexpected(setup.error());
    setup_ = *setup;
    return programs_.contains(setup_) ? Expected<void>{} : compile(setup_);
}

void SurfaceShader::draw(const Scene& scene) {
    EXPECTS(scene.lights.size() == static_cast<std::size_t>(setup_.count));
    block_.replace_by(shading_block(scene, *surface_, attenuation_));
    block_.bind_uniform_block(0);
    programs_.at(setup_).use();
    vertex_array_.draw();
}

} // namespace renderer::shading
