// The light's view of the mesh, and the shader that reads it.
#include "renderer/methods/green.h"

#include "renderer/gpu/target.h"
#include "renderer/methods/green.frag.h"
#include "renderer/methods/green_depth.frag.h"
#include "renderer/methods/green_depth.vert.h"
#include "renderer/methods/phong.vert.h"
#include "renderer/methods/shading.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace renderer::methods {

namespace {

// The map's depths reach a little beyond the bounding sphere, so that 1 always means "empty".
constexpr double depth_reach = 1.0 + 1.0 / 1024;

struct LightBlock { // block Light of green.frag, std140
    glm::mat4 light_from_world{1};
    float texel = 0;
    float depth_range = 0;
    std::array<float, 2> padding{};
};

struct LightView {
    glm::dmat4 light_from_world; // x and y over the radius; z from the near side of the sphere, mm
    double radius;               // of the placed bounding sphere, mm
};

// |A d| <= radius |d| for every d: the exact stretch where the placement scales evenly.
double largest_stretch(const glm::dmat3& linear) {
    const auto squared = glm::transpose(linear) * linear;
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        largest = std::max(largest, std::abs(squared[i].x) + std::abs(squared[i].y) +
                                        std::abs(squared[i].z));
    return std::sqrt(largest);
}

// z(x) = r - L.(x - c), and u, v perpendicular to L.
LightView light_view(const Scene& scene, const Surface& surface) {
    const auto L = glm::normalize(scene.light.to_light);
    const auto helper = std::abs(L.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const auto u = glm::normalize(glm::cross(helper, L));
    const auto v = glm::cross(L, u);
    const auto& sphere = surface.model_sphere();
    const glm::dvec3 c(scene.placement.world_from_model * glm::dvec4(sphere.centre, 1));
    const double r = sphere.radius * largest_stretch(glm::dmat3(scene.placement.world_from_model));
    const glm::dmat4 rows(glm::dvec4(u / r, -glm::dot(u, c) / r),
                          glm::dvec4(v / r, -glm::dot(v, c) / r),
                          glm::dvec4(-L, r + glm::dot(L, c)), glm::dvec4(0, 0, 0, 1));
    return {glm::transpose(rows), r};
}

class Green : public Method {
  public:
    Green(SurfaceShader shader, gpu::Program light_pass, gpu::DepthMap map)
        : shader_(std::move(shader)), light_pass_(std::move(light_pass)), map_(std::move(map)),
          light_array_(shader_.surface().vertex_array()), light_pass_block_(sizeof(glm::mat4)),
          light_block_(sizeof(LightBlock)) {}

    Expected<void> relight(const Scene& scene) override {
        if (const auto light = model_light(scene); !light)
            return tl::make_unexpected(light.error());
        const auto view = light_view(scene, shader_.surface());
        const double depth_range = 2 * view.radius * depth_reach;
        light_block_.replace_by(
            LightBlock{.light_from_world = glm::mat4(view.light_from_world),
                       .texel = static_cast<float>(2 * view.radius / map_.resolution()),
                       .depth_range = static_cast<float>(depth_range)});

        // Clip depth runs from -1 at z = 0 to 1 at z = depth_range.
        const auto clip_from_light =
            glm::scale(glm::translate(glm::dmat4(1), {0, 0, -1}), {1, 1, 2 / depth_range});
        const auto world_from_object = shader_.surface().world_from_object(scene.placement);
        light_pass_block_.replace_by(
            glm::mat4(clip_from_light * view.light_from_world * world_from_object));
        map_.clear();
        const auto drawing = map_.draw_into();
        light_pass_block_.bind_uniform_block(0);
        light_pass_.use();
        light_array_.draw();
        return {};
    }

    void draw(const Scene& scene) override {
        map_.bind_texture(0);
        light_block_.bind_uniform_block(1);
        shader_.draw(scene);
    }

    Cost cost() const override {
        const auto edge = static_cast<std::size_t>(map_.resolution());
        return {.bytes_per_light = light_block_.bytes() + edge * edge * sizeof(float),
                .passes_per_light = 1};
    }

  private:
    SurfaceShader shader_;
    gpu::Program light_pass_;
    gpu::DepthMap map_;
    gpu::VertexArray light_array_;
    gpu::Buffer light_pass_block_;
    gpu::Buffer light_block_;
};

} // namespace

Expected<std::unique_ptr<Method>> prepare_green(const GreenSettings& settings,
                                                std::shared_ptr<const Surface> surface,
                                                const thickness::ThicknessField* field) {
    const auto attenuation = attenuation_for(settings.law, field);
    if (!attenuation)
        return tl::make_unexpected(attenuation.error());
    const std::array vertex{gpu::ShaderPart{"phong.vert", phong_vert}};
    const std::array fragment{gpu::ShaderPart{"green.frag", green_frag}};
    auto shader = SurfaceShader::prepare(std::move(surface), *attenuation, vertex, fragment);
    if (!shader)
        return tl::make_unexpected(shader.error());
    const std::array light_vertex{gpu::ShaderPart{"green_depth.vert", green_depth_vert}};
    const std::array light_fragment{gpu::ShaderPart{"green_depth.frag", green_depth_frag}};
    auto light_pass = gpu::Program::link(light_vertex, light_fragment);
    if (!light_pass)
        return tl::make_unexpected(light_pass.error());
    auto map = gpu::DepthMap::create(settings.depth_map);
    if (!map)
        return tl::make_unexpected(map.error());
    return std::make_unique<Green>(std::move(*shader), std::move(*light_pass), std::move(*map));
}

} // namespace renderer::methods
