// Plain numbers of the study file become placements, cameras and lights.
#include "experiment/staging.h"

#include "renderer/camera.h"

namespace experiment {

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

renderer::Millimetres diameter_of(const protocols::Scene& scene,
                                  const renderer::geometry::BoundingSphere& model) {
    return {scene.mm_per_unit ? 2 * model.radius * *scene.mm_per_unit : scene.diameter_mm};
}

renderer::Scene staged(const protocols::Scene& scene,
                       const renderer::geometry::BoundingSphere& model,
                       double aspect) {
    const auto& up = scene.up;
    const renderer::Turntable turntable{
        scene.turn_degrees, scene.elevation_degrees, {up[0], up[1], up[2]}};
    const auto diameter = diameter_of(scene, model);
    renderer::Scene seen;
    seen.placement = renderer::place(model, diameter, turntable);
    seen.camera = renderer::frame(diameter, turntable, aspect);
    return seen;
}

std::vector<renderer::Light> lights_of(const protocols::Variant& variant,
                                       const renderer::Camera& camera) {
    std::vector<renderer::Light> lights;
    for (const auto& light : variant.lights)
        lights.push_back(light_of(light, camera));
    return lights;
}

} // namespace experiment
