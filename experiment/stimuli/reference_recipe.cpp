// A recipe is a line that people can read.
#include "experiment/stimuli/reference_recipe.h"

#include "experiment/stimuli/reference_file.h"

#include <fmt/format.h>

#include <numbers>
#include <system_error>

namespace experiment::stimuli {

namespace reference = renderer::reference;

namespace {

std::string words_of(const protocols::Light& light) {
    const bool is_far = light.kind == protocols::Light::Kind::Far;
    const auto& [x, y, z] = is_far ? light.to_light : light.position_mm;
    const auto& [r, g, b] = light.intensity;
    return fmt::format("{} {} {} {} reference_mm {} intensity {} {} {}", is_far ? "far" : "near", x,
                       y, z, light.reference_mm, r, g, b);
}

} // namespace

std::string reference_recipe(const protocols::Study& study,
                             const protocols::Scene& scene,
                             const protocols::Variant& variant,
                             const ModelRecord& model,
                             const reference::ReferenceSettings& settings) {
    auto recipe = fmt::format(
        "model {} {} up {} {} {} turn {} elevation {} diameter_mm {} material {} pixels {} x {} "
        "boundary {} roughness {} anisotropy {} sun_degrees {:.10g}",
        model.file, model.sha256, scene.up[0], scene.up[1], scene.up[2], scene.turn_degrees,
        scene.elevation_degrees, scene.diameter_mm, scene.material, study.width, study.height,
        reference::name_of(settings.boundary.kind), settings.boundary.roughness,
        settings.anisotropy, settings.sun_half_angle.value * 180 / std::numbers::pi);
    if (scene.mm_per_unit)
        recipe += fmt::format(" mm_per_unit {}", *scene.mm_per_unit);
    for (const auto& light : variant.lights)
        recipe += " light " + words_of(light);
    return recipe;
}

tl::expected<reference::Film, std::string> film_to_go_on_with(const std::filesystem::path& file,
                                                              const std::string& recipe,
                                                              const protocols::Study& study,
                                                              std::uint64_t seed) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        return reference::blank_film(study.width, study.height, seed);
    auto stored = read_reference(file);
    if (!stored)
        return tl::unexpected(stored.error());
    if (stored->recipe != recipe || stored->film.seed != seed)
        return tl::unexpected(fmt::format("{}: is a reference of something else; name another "
                                          "file, or take it away",
                                          file.string()));
    return std::move(stored->film);
}

} // namespace experiment::stimuli
