// Plain triples of the study file become the renderer's types.
#include "experiment/materials.h"

#include "renderer/materials.h"

namespace experiment {

namespace {

renderer::RgbPerMillimetre per_millimetre(const std::array<double, 3>& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

renderer::Material made_of(const protocols::Coefficients& medium) {
    return renderer::material_of({.sigma_a = per_millimetre(medium.sigma_a),
                                  .sigma_s_reduced = per_millimetre(medium.sigma_s_reduced),
                                  .index = medium.index});
}

renderer::Material made_of(const protocols::Colour& colour) {
    const auto& R = colour.reflectance;
    const auto& d = colour.mean_free_path_mm;
    const renderer::LinearRgb rgb{static_cast<float>(R[0]), static_cast<float>(R[1]),
                                  static_cast<float>(R[2])};
    return {renderer::medium_of_colour(rgb, {{{d[0]}, {d[1]}, {d[2]}}}), renderer::preset(rgb)};
}

} // namespace

std::optional<renderer::Material> material_of(const protocols::Study& study,
                                              const protocols::Scene& scene) {
    const auto* own = protocols::own_material(study, scene.material);
    if (own == nullptr)
        return renderer::measured_material(scene.material);
    return std::visit([](const auto& medium) { return made_of(medium); }, own->medium);
}

} // namespace experiment
