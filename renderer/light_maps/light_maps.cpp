// The light's pass over the mesh, layer by layer and face by face.
#include "renderer/light_maps/light_maps.h"

#include "renderer/contract.h"
#include "renderer/light_maps/light_maps.glsl.h"
#include "renderer/light_maps/light_pass.frag.h"
#include "renderer/light_maps/light_pass.glsl.h"
#include "renderer/light_maps/light_pass.vert.h"
#include "renderer/light_maps/light_views.glsl.h"
#include "renderer/shading/lighting.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace renderer::light_maps {

namespace {

// Depths reach a little beyond the body, so that the farthest is nearer than nothing.
constexpr double depth_reach = 1.0 + 1.0 / 1024;

constexpr int cube_faces = 6;

struct View { // of light_views.glsl, std140
    glm::vec4 u{}, v{}, toward{}, origin{}, extent{};
};

using Views = std::array<View, most_lights>;

struct PassBlock { // block LightPass of light_pass.glsl, std140
    glm::mat4 world_from_object{1};
    int light = 0;
    int face = 0;
    int layer = 0;
    int peeling = 0;
    int mirrored = 0;
    std::array<int, 3> padding{};
};

struct Sphere {
    glm::dvec3 centre;
    double radius;
};

Sphere placed_sphere(const shading::Surface& surface, const Placement& placement) {
    const auto& sphere = surface.model_sphere();
    return {glm::dvec3(placement.world_from_model * glm::dvec4(sphere.centre, 1)),
            sphere.radius * shading::largest_stretch(glm::dmat3(placement.world_from_model))};
}

View far_view(const DirectionalLight& light, const Sphere& body) {
    const auto L = glm::normalize(light.to_light);
    const auto helper = std::abs(L.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const auto u = glm::normalize(glm::cross(helper, L));
    const double range = 2 * body.radius * depth_reach;
    return {.u = glm::vec4(u, 0),
            .v = glm::vec4(glm::cross(L, u), 0),
            .toward = glm::vec4(L, 0),
            .origin = glm::vec4(body.centre, body.radius),
            .extent = glm::vec4(range, 0, 0, 0)};
}

View near_view(const PointLight& light, const Sphere& body) {
    const double farthest = glm::distance(light.position, body.centre) + body.radius;
    return {.toward = glm::vec4(0, 0, 0, 1),
            .origin = glm::vec4(light.position, 0),
            .extent = glm::vec4(farthest * depth_reach, 0, 0, 0)};
}

bool is_near(const Light& light) {
    return std::holds_alternative<PointLight>(light.place);
}

int faces_of(const Light& light) {
    return is_near(light) ? cube_faces : 1;
}

Views views_of(const Scene& scene, const Sphere& body) {
    Views views;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const auto& place = scene.lights[i].place;
        const auto* far = std::get_if<DirectionalLight>(&place);
        views[i] =
            far != nullptr ? far_view(*far, body) : near_view(std::get<PointLight>(place), body);
    }
    return views;
}

Expected<gpu::Program> link_pass(std::string_view defines) {
    const gpu::ShaderPart head{"defines", defines}, views{"light_views.glsl", light_views_glsl},
        pass{"light_pass.glsl", light_pass_glsl};
    const std::array vertex{head, views, pass, gpu::ShaderPart{"light_pass.vert", light_pass_vert}};
    const std::array fragment{head, views, pass,
                              gpu::ShaderPart{"light_pass.frag", light_pass_frag}};
    return gpu::Program::link(vertex, fragment);
}

} // namespace

LightMaps::LightMaps(std::shared_ptr<const shading::Surface> surface,
                     gpu::Program linear_pass,
                     gpu::Program pass,
                     gpu::LayeredMap first,
                     int layers)
    : surface_(std::move(surface)), linear_pass_(std::move(linear_pass)), pass_(std::move(pass)),
      vertex_array_(surface_->vertex_array()), pass_block_(sizeof(PassBlock)),
      views_(sizeof(Views)), resolution_(first.resolution()), layers_(layers) {
    maps_.push_back(std::move(first));
}

Expected<LightMaps>
LightMaps::prepare(std::shared_ptr<const shading::Surface> surface, int resolution, int layers) {
    auto linear_pass = link_pass("#define LINEAR");
    if (!linear_pass)
        return tl::make_unexpected(linear_pass.error());
    auto pass = link_pass("");
    if (!pass)
        return tl::make_unexpected(pass.error());
    auto first = gpu::LayeredMap::create(resolution, layers, gpu::LayeredMap::Reading::Nearest);
    if (!first)
        return tl::make_unexpected(first.error());
    return LightMaps(std::move(surface), std::move(*linear_pass), std::move(*pass),
                     std::move(*first), layers);
}

Expected<void> LightMaps::make_room(const Scene& scene) {
    maps_.erase(maps_.begin() + std::min(std::ssize(maps_), std::ssize(scene.lights)), maps_.end());
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const auto& light = scene.lights[i];
        const int resolution = is_near(light) ? (resolution_ + 1) / 2 : resolution_;
        const int layers = layers_ * faces_of(light);
        if (i < maps_.size() && maps_[i].resolution() == resolution && maps_[i].layers() == layers)
            continue;
        auto map = gpu::LayeredMap::create(resolution, layers, gpu::LayeredMap::Reading::Nearest);
        if (!map)
            return tl::make_unexpected(map.error());
        if (i < maps_.size())
            maps_[i] = std::move(*map);
        else
            maps_.push_back(std::move(*map));
    }
    return {};
}

Expected<void> LightMaps::fill(const Scene& scene) {
    if (const auto room = make_room(scene); !room)
        return room;
    views_.replace_by(views_of(scene, placed_sphere(*surface_, scene.placement)));
    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light)
        draw(scene, light);
    return {};
}

void LightMaps::draw(const Scene& scene, int light) {
    const auto& map = maps_[static_cast<std::size_t>(light)];
    const bool mirrored = glm::determinant(glm::dmat3(scene.placement.world_from_model)) < 0;
    // Peeling compares what the fragments say, so they have to decide what is nearest, too.
    const bool linear = layers_ == 1 && !is_near(scene.lights[static_cast<std::size_t>(light)]);
    map.bind_texture(0);
    views_.bind_uniform_block(1);
    for (int layer = 0; layer < map.layers(); ++layer) {
        const auto drawing = map.draw_into(layer);
        pass_block_.replace_by(
            PassBlock{.world_from_object = glm::mat4(surface_->world_from_object(scene.placement)),
                      .light = light,
                      .face = layer / layers_,
                      .layer = layer,
                      .peeling = layer % layers_ == 0 ? 0 : 1,
                      .mirrored = mirrored ? 1 : 0});
        pass_block_.bind_uniform_block(0);
        (linear ? linear_pass_ : pass_).use();
        vertex_array_.draw();
    }
}

void LightMaps::bind() const {
    for (unsigned i = 0; i < maps_.size(); ++i)
        maps_[i].bind_texture(i);
    bind_views();
}

std::string LightMaps::defines() const {
    return fmt::format("#define LAYERS {}\n", layers_);
}

std::vector<gpu::ShaderPart> LightMaps::shader_parts() {
    return {{"light_views.glsl", light_views_glsl}, {"light_maps.glsl", light_maps_glsl}};
}

std::size_t LightMaps::bytes_per_light() const {
    std::size_t most = 0;
    for (const auto& map : maps_)
        most = std::max(most, map.bytes());
    return most;
}

int LightMaps::passes_per_light() const {
    int most = 0;
    for (const auto& map : maps_)
        most = std::max(most, map.layers());
    return most;
}

} // namespace renderer::light_maps
