// From a study's words to matter, lights and camera.
#include "experiment/stimuli/lit_scene.h"

#include "experiment/materials.h"
#include "renderer/camera.h"

#include <fmt/format.h>

namespace experiment::stimuli {

namespace {

renderer::Light light_of(const protocols::Light& light, const renderer::Camera& camera) {
    const auto& [r, g, b] = light.intensity;
    renderer::Light placed;
    placed.intensity = {static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)};
    if (light.kind == protocols::Light::Kind::Far) {
        const auto& [x, y, z] = light.to_light;
        placed.place =
            renderer::DirectionalLight{renderer::world_from_view_axes(camera, {x, y, z})};
    } else {
        // The scene's centre is the world's origin: a place turns like a direction.
        const auto& [x, y, z] = light.position_mm;
        placed.place = renderer::PointLight{renderer::world_from_view_axes(camera, {x, y, z}),
                                            renderer::Millimetres{light.reference_mm}};
    }
    return placed;
}

} // namespace

tl::expected<renderer::Scene, std::string> seen_scene(const protocols::Study& study,
                                                      const protocols::Scene& scene,
                                                      const renderer::geometry::Mesh& mesh) {
    const auto material = material_of(study, scene);
    if (!material)
        return tl::unexpected(fmt::format("no material \"{}\"", scene.material));
    const auto& up = scene.up;
    const renderer::Turntable turntable{
        scene.turn_degrees, scene.elevation_degrees, {up[0], up[1], up[2]}};
    const auto sphere = renderer::geometry::bounding_sphere(mesh);
    const renderer::Millimetres diameter{scene.mm_per_unit ? 2 * sphere.radius * *scene.mm_per_unit
                                                           : scene.diameter_mm};
    renderer::Scene seen;
    seen.placement = renderer::place(sphere, diameter, turntable);
    seen.camera =
        renderer::frame(diameter, turntable, static_cast<double>(study.width) / study.height);
    seen.material = *material;
    return seen;
}

tl::expected<renderer::Scene, std::string> lit_scene(const protocols::Study& study,
                                                     const protocols::Scene& scene,
                                                     const protocols::Variant& variant,
                                                     const renderer::geometry::Mesh& mesh) {
    auto lit = seen_scene(study, scene, mesh);
    if (!lit)
        return lit;
    lit->lights.clear();
    for (const auto& light : variant.lights)
        lit->lights.push_back(light_of(light, lit->camera));
    return lit;
}

} // namespace experiment::stimuli
