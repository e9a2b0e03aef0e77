// The eye walks, the world stands.
#include "experiment/viewer/viewpoint.h"

#include "experiment/staging.h"
#include "renderer/camera.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

namespace experiment::viewer {

namespace {

renderer::Camera camera(const protocols::Scene& scene,
                        renderer::Millimetres diameter,
                        const Orbit& orbit,
                        double aspect) {
    const glm::dmat4 one(1);
    auto camera = renderer::frame(
        diameter, {.elevation_degrees = scene.elevation_degrees + orbit.up_degrees}, aspect);
    // Walking to the right is the world turning to the left.
    camera.view_from_world =
        camera.view_from_world *
        glm::rotate(one, glm::radians(-orbit.right_degrees), glm::dvec3(0, 1, 0));
    camera.clip_from_view =
        glm::scale(one, glm::dvec3(orbit.zoom, orbit.zoom, 1)) * camera.clip_from_view;
    return camera;
}

void turn(renderer::Light& light, const glm::dquat& by) {
    if (auto* far = std::get_if<renderer::DirectionalLight>(&light.place))
        far->to_light = glm::normalize(by * far->to_light);
    else
        std::get<renderer::PointLight>(light.place).position =
            by * std::get<renderer::PointLight>(light.place).position;
}

} // namespace

glm::dmat3 world_from_view(const protocols::Scene& scene, const Orbit& orbit) {
    constexpr renderer::Millimetres any{1};
    return glm::transpose(glm::dmat3(camera(scene, any, orbit, 1).view_from_world));
}

renderer::Scene seen(const ViewerState& state,
                     const Exhibit& exhibit,
                     const renderer::geometry::BoundingSphere& model,
                     double aspect) {
    const auto& [scene, material] = exhibit.pieces[state.scene];
    auto view = staged(scene, model, aspect);
    view.material = material;
    view.lights = lights_of(exhibit.variants[state.variant], view.camera);
    for (auto& light : view.lights)
        turn(light, state.light_turn);
    view.camera = camera(scene, diameter_of(scene, model), state.orbit, aspect);
    return view;
}

} // namespace experiment::viewer
