// From a study's words to matter, lights and camera.
#include "experiment/stimuli/lit_scene.h"

#include "experiment/materials.h"
#include "experiment/staging.h"

#include <fmt/format.h>

namespace experiment::stimuli {

tl::expected<renderer::Scene, std::string> seen_scene(const protocols::Study& study,
                                                      const protocols::Scene& scene,
                                                      const renderer::geometry::Mesh& mesh) {
    const auto material = material_of(study, scene);
    if (!material)
        return tl::unexpected(fmt::format("no material \"{}\"", scene.material));
    auto seen = staged(scene, renderer::geometry::bounding_sphere(mesh),
                       static_cast<double>(study.width) / study.height);
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
    lit->lights = lights_of(variant, lit->camera);
    return lit;
}

} // namespace experiment::stimuli
