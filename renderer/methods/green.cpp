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

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace renderer::methods {

namespace {

// The map's depths reach a little beyond the bounding sphere, so that 1 always means "empty".
constexpr double depth_reach = 1.0 + 1.0 / 1024;

struct MapsBlock { // block Maps of green.frag, std140
    std::array<glm::mat4, most_lights> light_from_world{};
    float texel = 0;
    float depth_range = 0;
    std::array<float, 2> padding{};
};

struct LightView {
    glm::dmat4 light_from_world; // x and y over the radius; z from the near side of the sphere, mm
    double radius;               // of the placed bounding sphere, mm
};

// z(x) = r - L.(x - c), and u, v perpendicular to L.
LightView
light_view(const DirectionalLight& light, const Placement& placement, const Surface& surface) {
    const auto L = glm::normalize(light.to_light);
    const auto helper = std::abs(L.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const auto u = glm::normalize(glm::cross(helper, L));
    const auto v = glm::cross(L, u);
    const auto& sphere = surface.model_sphere();
    const glm::dvec3 c(placement.world_from_model * glm::dvec4(sphere.centre, 1));
    const double r = sphere.radius * largest_stretch(glm::dmat3(placement.world_from_model));
    const glm::dmat4 rows(glm::dvec4(u / r, -glm::dot(u, c) / r),
                          glm::dvec4(v / r, -glm::dot(v, c) / r),
                          glm::dvec4(-L, r + glm::dot(L, c)), glm::dvec4(0, 0, 0, 1));
    return {glm::transpose(rows), r};
}

class Green : public Method {
  public:
    Green(SurfaceShader shader, gpu::Program light_pass, gpu::DepthMap map)
        : shader_(std::move(shader)), light_pass_(std::move(light_pass)),
          light_array_(shader_.surface().vertex_array()), light_pass_block_(sizeof(glm::mat4)),
          maps_block_(sizeof(MapsBlock)) {
        maps_.push_back(std::move(map));
    }

    Expected<void> update(const Scene& scene, double) override {
        if (const auto ready = shader_.adapt(scene); !ready)
            return ready;
        if (lit_ == lighting_of(scene))
            return {};
        lit_.reset();
        while (maps_.size() < scene.lights.size()) {
            auto map = gpu::DepthMap::create(maps_.front().resolution());
            if (!map)
                return tl::make_unexpected(map.error());
            maps_.push_back(std::move(*map));
        }
        MapsBlock block;
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            const auto* light = std::get_if<DirectionalLight>(&scene.lights[i].place);
            if (light == nullptr)
                return tl::make_unexpected("Green's depth map under a point light, expected "
                                           "directional lights");
            const auto view = light_view(*light, scene.placement, shader_.surface());
            fill_map(view, scene.placement, maps_[i]);
            block.light_from_world[i] = glm::mat4(view.light_from_world);
            block.texel = static_cast<float>(2 * view.radius / maps_[i].resolution());
            block.depth_range = static_cast<float>(depth_range(view));
        }
        maps_block_.replace_by(block);
        lit_ = lighting_of(scene);
        return {};
    }

    void draw(const Scene& scene) override {
        for (unsigned i = 0; i < scene.lights.size(); ++i)
            maps_[i].bind_texture(i);
        maps_block_.bind_uniform_block(1);
        shader_.draw(scene);
    }

    Cost cost() const override {
        const auto edge = static_cast<std::size_t>(maps_.front().resolution());
        return {.bytes_per_light = sizeof(glm::mat4) + edge * edge * sizeof(float),
                .passes_per_light = 1};
    }

  private:
    static double depth_range(const LightView& view) { return 2 * view.radius * depth_reach; }

    void fill_map(const LightView& view, const Placement& placement, const gpu::DepthMap& map) {
        // Clip depth runs from -1 at z = 0 to 1 at z = depth_range.
        const auto clip_from_light =
            glm::scale(glm::translate(glm::dmat4(1), {0, 0, -1}), {1, 1, 2 / depth_range(view)});
        const auto world_from_object = shader_.surface().world_from_object(placement);
        light_pass_block_.replace_by(
            glm::mat4(clip_from_light * view.light_from_world * world_from_object));
        map.clear();
        const auto drawing = map.draw_into();
        light_pass_block_.bind_uniform_block(0);
        light_pass_.use();
        light_array_.draw();
    }

    SurfaceShader shader_;
    gpu::Program light_pass_;
    std::vector<gpu::DepthMap> maps_;
    gpu::VertexArray light_array_;
    gpu::Buffer light_pass_block_;
    gpu::Buffer maps_block_;
    std::optional<Lighting> lit_;
};

Dial depth_map_dial() {
    return {.name = "depth_map",
            .meaning = "texels along an edge of the light's depth map",
            .preset = std::int64_t{2048},
            .whole = DialRange<std::int64_t>{16, 16384}};
}

} // namespace

Description describe_green() {
    return {.name = "green",
            .label = "Green 2004",
            .source = "Green2004",
            .dials = {law_dial(), depth_map_dial()},
            .prepare = [](const Dials& dials, const Subject& subject) {
                const GreenSettings settings{static_cast<int>(whole_in(dials, "depth_map")),
                                             law_of(dials)};
                return field_with_d_n(settings.law, subject).and_then([&](const auto& field) {
                    return prepare_green(settings, subject.surface, field.get());
                });
            }};
}

Expected<std::unique_ptr<Method>> prepare_green(const GreenSettings& settings,
                                                std::shared_ptr<const Surface> surface,
                                                const thickness::ThicknessField* field) {
    const auto attenuation = attenuation_for(settings.law, field);
    if (!attenuation)
        return tl::make_unexpected(attenuation.error());
    auto shader = SurfaceShader::prepare(
        std::move(surface), *attenuation,
        {.vertex = {{"phong.vert", phong_vert}}, .fragment = {{"green.frag", green_frag}}});
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
