// One pair of shaders, and lights in the model's axes.
#include "renderer/shading/body_radiance.h"

#include "renderer/shading/body_radiance.frag.h"
#include "renderer/shading/body_radiance.vert.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace renderer::shading {

Expected<SurfaceShader> body_radiance_shader(std::shared_ptr<const Surface> surface) {
    return SurfaceShader::prepare(std::move(surface), {},
                                  {.vertex = {{"body_radiance.vert", body_radiance_vert}},
                                   .fragment = {{"body_radiance.frag", body_radiance_frag}}});
}

std::vector<IncidentLight> incident_lights(const Scene& scene, const Surface& surface) {
    const glm::dvec3 centre(scene.placement.world_from_model *
                            glm::dvec4(surface.model_sphere().centre, 1));
    std::vector<IncidentLight> lights;
    for (const auto& light : scene.lights) {
        glm::dvec3 irradiance(light.intensity.r, light.intensity.g, light.intensity.b);
        irradiance *= std::numbers::pi;
        DirectionalLight far;
        if (const auto* near = std::get_if<PointLight>(&light.place)) {
            const auto way = near->position - centre;
            const double squared = std::max(glm::dot(way, way), 1e-30); // as shading.glsl
            irradiance *= near->reference.value * near->reference.value / squared;
            far.to_light = squared > 1e-30 ? glm::normalize(way) : glm::dvec3(0, 0, 1);
        } else {
            far = std::get<DirectionalLight>(light.place);
        }
        lights.push_back({model_light(far, scene.placement).to_light, irradiance});
    }
    return lights;
}

double mm_per_unit(const Placement& placement) {
    return std::cbrt(std::abs(glm::determinant(glm::dmat3(placement.world_from_model))));
}

} // namespace renderer::shading
