// Measures by name, for programs and for people.
#include "experiment/errors_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace experiment {

namespace {

using Json = nlohmann::ordered_json;
using renderer::imaging::ImageErrors;

std::array<std::pair<const char*, double>, 7> named(const ImageErrors& errors) {
    return {{{"RMSE", errors.rmse},
             {"MAE", errors.mae},
             {"relMSE", errors.rel_mse},
             {"PSNR", errors.psnr},
             {"SSIM", errors.ssim},
             {"LDR-FLIP", errors.ldr_flip},
             {"HDR-FLIP", errors.hdr_flip}}};
}

Json as_json(const ImageErrors& errors) {
    Json json;
    for (const auto& [name, value] : named(errors))
        json[name] = std::isinf(value) ? Json("inf") : Json(value);
    json["exposures"] = {{"first", errors.exposures.first},
                         {"last", errors.exposures.last},
                         {"count", errors.exposures.count},
                         {"tone_mapper", "ACES"}};
    return json;
}

} // namespace

std::string errors_json(const Comparison& comparison) {
    Json json = as_json(comparison.raw);
    json["equalised"] = as_json(comparison.equalised);
    json["equalised"]["gain"] = comparison.gain;
    if (comparison.noise_floor)
        json["noise_floor"] = as_json(*comparison.noise_floor);
    json["pixels"] = comparison.pixels;
    json["pixels_per_degree"] = comparison.pixels_per_degree;
    return json.dump(2) + "\n";
}

std::string errors_text(const Comparison& comparison) {
    const auto raw = named(comparison.raw), equalised = named(comparison.equalised);
    std::string text =
        fmt::format("{:<10}{:>14}{:>14}{}\n", "", "raw", "equalised",
                    comparison.noise_floor ? fmt::format("{:>14}", "noise floor") : "");
    for (std::size_t i = 0; i < raw.size(); ++i) {
        text += fmt::format("{:<10}{:>14.6g}{:>14.6g}", raw[i].first, raw[i].second,
                            equalised[i].second);
        if (comparison.noise_floor)
            text += fmt::format("{:>14.6g}", named(*comparison.noise_floor)[i].second);
        text += '\n';
    }
    return text + fmt::format("over {} pixels; equalised: brightness times {:.6g}\n",
                              comparison.pixels, comparison.gain);
}

} // namespace experiment
