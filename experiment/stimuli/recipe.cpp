// Doubles are written with all their digits, so that equal text means equal numbers.
#include "experiment/stimuli/recipe.h"

#include "protocols/digest.h"

#include <fmt/core.h>

namespace experiment::stimuli {

namespace {

std::string described(const protocols::Scene& scene) {
    return fmt::format("scene {} {} turn {} elevation {} up {} {} {} diameter {} material {}\n",
                       scene.id.value, scene.model, scene.turn_degrees, scene.elevation_degrees,
                       scene.up[0], scene.up[1], scene.up[2], scene.diameter_mm, scene.material);
}

std::string described(const protocols::Condition& condition) {
    std::string text = fmt::format("condition {}", condition.id.value);
    if (const auto* rendering = std::get_if<protocols::Rendering>(&condition.source))
        for (const auto& [name, value] : dials(*rendering))
            text += fmt::format(" {}={}", name, value);
    return text + '\n';
}

} // namespace

std::map<std::string, std::string> dials(const protocols::Rendering& rendering) {
    std::map<std::string, std::string> named{{"method", rendering.method}};
    if (rendering.method != "phong")
        named["law"] = rendering.law;
    if (rendering.method == "green")
        named["depth_map"] = fmt::format("{}", rendering.depth_map);
    if (rendering.method == "shss") {
        named["bands"] = fmt::format("{}", rendering.bands);
        named["directions"] = fmt::format("{}", rendering.directions);
        named["thickness"] = rendering.thickness;
    }
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
    text += fmt::format("light {} {} {}\n", variant.to_light[0], variant.to_light[1],
                        variant.to_light[2]);
    for (const auto& condition : study.conditions)
        text += described(condition);
    return protocols::sha256_hexadecimal(text);
}

} // namespace experiment::stimuli
