// From a study's words to matter, light and camera.
#include "experiment/stimuli/lit_scene.h"

#include "renderer/camera.h"
#include "renderer/materials.h"

#include <fmt/format.h>

namespace experiment::stimuli {

tl::expected<renderer::Scene, std::string> lit_scene(const protocols::Study& study,
                                                     const protocols::Scene& scene,
                                                     const protocols::Variant& variant,
                                                     const renderer::geometry::Mesh& mesh) {
    const auto material = renderer::measured_material(scene.material);
    if (!material)
        return tl::unexpected(fmt::format("no material \"{}\"", scene.material));
    const auto& up = scene.up;
    const renderer::Turntable turntable{
        scene.turn_degrees, scene.elevation_degrees, {up[0], up[1], up[2]}};
    const renderer::Millimetres diameter{scene.diameter_mm};
    renderer::Scene lit;
    lit.placement = renderer::place(renderer::geometry::bounding_sphere(mesh), diameter, turntable);
    lit.camera =
        renderer::frame(diameter, turntable, static_cast<double>(study.width) / study.height);
    lit.material = *material;
    const auto& to_light = variant.to_light;
    lit.light.to_light =
        renderer::world_from_view_axes(lit.camera, {to_light[0], to_light[1], to_light[2]});
    return lit;
}

} // namespace experiment::stimuli
