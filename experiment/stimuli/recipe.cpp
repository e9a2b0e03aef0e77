// Doubles are written with all their digits, so that equal text means equal numbers.
#include "experiment/stimuli/recipe.h"

#include "protocols/digest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace experiment::stimuli {

namespace {

const std::string path_tracer = "path tracer, beside ";

std::string described(const protocols::Scene& scene) {
    const auto size = scene.mm_per_unit ? fmt::format("unit {}", *scene.mm_per_unit)
                                        : fmt::format("diameter {}", scene.diameter_mm);
    return fmt::format("scene {} {} turn {} elevation {} up {} {} {} {} material {}\n",
                       scene.id.value, scene.model, scene.turn_degrees, scene.elevation_degrees,
                       scene.up[0], scene.up[1], scene.up[2], size, scene.material);
}

std::string described(const protocols::Coefficients& medium) {
    return fmt::format("absorbs {} scatters {} index {}", fmt::join(medium.sigma_a, " "),
                       fmt::join(medium.sigma_s_reduced, " "), medium.index);
}

std::string described(const protocols::Colour& colour) {
    return fmt::format("colour {} spreads {}", fmt::join(colour.reflectance, " "),
                       fmt::join(colour.mean_free_path_mm, " "));
}

/// What a name of the study's own stands for; a measured one belongs to the program.
std::string described_material(const protocols::Study& study, const protocols::Scene& scene) {
    const auto* own = protocols::own_material(study, scene.material);
    return own == nullptr ? ""
                          : std::visit(
                                [](const auto& medium) {
                                    return fmt::format("material {}\n", described(medium));
                                },
                                own->medium);
}

std::string described(const protocols::Light& light) {
    const auto& where =
        light.kind == protocols::Light::Kind::Far ? light.to_light : light.position_mm;
    return fmt::format("light {} {} {} {} at {} intensity {} {} {}\n",
                       light.kind == protocols::Light::Kind::Far ? "toward" : "in", where[0],
                       where[1], where[2], light.reference_mm, light.intensity[0],
                       light.intensity[1], light.intensity[2]);
}

std::string described(const protocols::ShadingCoefficients& k) {
    return fmt::format("{} {} {} {}", fmt::join(k.ambient, " "), fmt::join(k.diffuse, " "),
                       fmt::join(k.specular, " "), fmt::join(k.scatter, " "));
}

/// With what is its own in the scene that is drawn.
std::string described(const protocols::Condition& condition, const protocols::Scene& scene) {
    std::string text = fmt::format("condition {}", condition.id.value);
    if (const auto* rendering = std::get_if<protocols::Rendering>(&condition.source)) {
        for (const auto& [name, value] : dials(*rendering))
            text += fmt::format(" {}={}", name, value);
        if (const auto own = rendering->k.find(scene.id.value); own != rendering->k.end())
            text += " k " + described(own->second);
    }
    return text + '\n';
}

} // namespace

std::map<std::string, std::string> dials(const protocols::Rendering& rendering) {
    std::map<std::string, std::string> named{{"method", rendering.method}};
    for (const auto& [name, value] : rendering.dials)
        named[name] = std::visit([](const auto& one) { return fmt::format("{}", one); }, value);
    return named;
}

std::string recipe(const protocols::Study& study,
                   const protocols::Scene& scene,
                   const protocols::Variant& variant,
                   const ModelRecord& model,
                   const std::string& renderer,
                   int samples) {
    std::string text = fmt::format("{}\n{}\nmodel {} {}\nsize {} {} samples {} surround {}\n",
                                   PAIRLIGHT_PROGRAM_VERSION, renderer, model.file, model.sha256,
                                   study.width, study.height, samples, study.surround.code);
    text += described(scene);
    text += described_material(study, scene);
    for (const auto& light : variant.lights)
        text += described(light);
    for (const auto& condition : study.conditions)
        text += described(condition, scene);
    return protocols::sha256_hexadecimal(text);
}

std::string path_tracer_beside(const std::string& renderer) {
    return path_tracer + renderer;
}

std::string renderer_of_run(const std::string& drawn_by) {
    return drawn_by.starts_with(path_tracer) ? drawn_by.substr(path_tracer.size()) : drawn_by;
}

} // namespace experiment::stimuli
