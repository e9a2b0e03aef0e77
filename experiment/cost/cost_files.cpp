// Optional members are written when they are there; nothing stands for "not measured".
#include "experiment/cost/cost_files.h"

#include "experiment/cost/cost_figures.h"
#include "experiment/tables.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace experiment::cost {

namespace {

using Json = nlohmann::ordered_json;
using renderer::cost::Spread;

std::string number(std::optional<double> value) {
    return value && !std::isnan(*value) ? fmt::format("{:.6g}", *value) : "";
}

template <class T>
void add(Json& json, const char* key, const std::optional<T>& value) {
    if (value)
        json[key] = *value;
}

Json as_json(const Spread& spread) {
    return {{"lower", spread.lower}, {"median", spread.median}, {"upper", spread.upper}};
}

Json as_json(const LightErrors& errors) {
    Json json = Json::object();
    add(json, "law", errors.law);
    add(json, "reference", errors.reference);
    add(json, "fitted", errors.fitted);
    add(json, "as_drawn", errors.as_drawn);
    add(json, "flip", errors.flip);
    if (!errors.decision.empty())
        json["decision"] = errors.decision;
    add(json, "predicted_change", errors.predicted_change);
    add(json, "measured_change", errors.measured_change);
    return json;
}

Json as_json(const Row& row) {
    Json json{{"method", row.method},
              {"label", row.label},
              {"setting", row.setting},
              {"dials", row.dials},
              {"vertices", row.vertices},
              {"triangles", row.triangles},
              {"mesh_bytes", row.mesh_bytes},
              {"bytes_per_vertex", row.bytes_per_vertex},
              {"bytes_per_light", row.bytes_per_light},
              {"frame_ms", as_json(row.frame_ms)},
              {"resting_ms", as_json(row.resting_ms)},
              {"to_bare", as_json(row.to_bare)},
              {"clock_ms", row.clock_ms},
              {"lights", Json::array()}};
    add(json, "precompute_seconds", row.precompute_seconds);
    add(json, "thickness", row.thickness);
    for (const auto& light : row.lights)
        json["lights"].push_back(as_json(light));
    return json;
}

Json as_json(const SceneCost& scene, std::size_t i) {
    const auto& light = scene.lights[i];
    Json json{{"id", light.id},
              {"label", light.label},
              {"width", light.width},
              {"height", light.height},
              {"reference", light.reference}};
    add(json, "noise_floor", light.noise_floor);
    if (const auto& choice = light.choice) {
        json["choice"] = {{"row", choice->row},
                          {"setting", full_name(scene.rows.at(choice->row))},
                          {"why", choice->why},
                          {"left_out", choice->left_out},
                          {"predicted", choice->predicted}};
        add(json["choice"], "measured", choice->measured);
    }
    for (const auto kind : all_errors)
        if (has_error(scene, i, kind))
            json["front"][std::string(name_of(kind))] = front_of(scene, i, kind);
    return json;
}

Json as_json(const SceneCost& scene) {
    Json json{{"id", scene.id},
              {"label", scene.label},
              {"model", scene.model},
              {"vertices", scene.vertices},
              {"triangles", scene.triangles},
              {"frame_width", scene.frame_width},
              {"frame_height", scene.frame_height},
              {"remarks", scene.remarks},
              {"lights", Json::array()},
              {"rows", Json::array()}};
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        json["lights"].push_back(as_json(scene, i));
    for (const auto& row : scene.rows)
        json["rows"].push_back(as_json(row));
    return json;
}

Json as_json(const Wish& wish) {
    Json json{{"error", std::string(name_of(wish.error))}};
    add(json, "tolerance", wish.tolerance);
    add(json, "budget_ms", wish.budget_ms);
    return json;
}

std::vector<std::string>
csv_fields(const SceneCost& scene, std::size_t i, std::size_t r, const CostReport& report) {
    const auto& light = scene.lights[i];
    const auto& row = scene.rows[r];
    const auto& errors = row.lights[i];
    const auto is_in = [&](ErrorKind kind) -> std::string {
        const auto all = front_of(scene, i, kind);
        return std::ranges::find(all, r) == all.end() ? "0" : "1";
    };
    return {scene.id,
            light.id,
            row.method,
            row.setting,
            number(row.precompute_seconds),
            std::to_string(row.bytes_per_vertex),
            std::to_string(row.bytes_per_light),
            std::to_string(row.vertices),
            std::to_string(row.triangles),
            std::to_string(row.mesh_bytes),
            number(row.frame_ms.median),
            number(row.frame_ms.lower),
            number(row.frame_ms.upper),
            number(row.resting_ms.median),
            number(row.to_bare.median),
            number(row.to_bare.lower),
            number(row.to_bare.upper),
            number(row.clock_ms),
            number(row.thickness),
            number(errors.law),
            number(errors.reference),
            number(errors.fitted),
            number(errors.as_drawn),
            number(errors.flip),
            number(light.noise_floor),
            is_in(ErrorKind::Thickness),
            is_in(ErrorKind::Law),
            is_in(ErrorKind::Reference),
            is_in(ErrorKind::Fitted),
            light.choice && light.choice->row == r ? std::string(name_of(report.wish.error)) : "",
            errors.decision,
            number(errors.predicted_change),
            number(errors.measured_change)};
}

} // namespace

std::string cost_csv(const CostReport& report) {
    auto text =
        csv_row({"scene",           "variant",          "method",          "setting",
                 "precompute_s",    "bytes_per_vertex", "bytes_per_light", "vertices",
                 "triangles",       "mesh_bytes",       "frame_ms",        "frame_ms_lower",
                 "frame_ms_upper",  "resting_ms",       "to_phong",        "to_phong_lower",
                 "to_phong_upper",  "clock_ms",         "thickness_error", "law_error",
                 "reference_error", "fitted_error",     "as_drawn_error",  "ldr_flip",
                 "noise_floor",     "front_thickness",  "front_law",       "front_reference",
                 "front_fitted",    "chosen_by",        "decision",        "predicted_change",
                 "measured_change"});
    for (const auto& scene : report.scenes)
        for (std::size_t i = 0; i < scene.lights.size(); ++i)
            for (std::size_t r = 0; r < scene.rows.size(); ++r)
                text += csv_row(csv_fields(scene, i, r, report));
    return text;
}

std::string cost_json(const CostReport& report) {
    Json json{{"form", form_version},
              {"program", report.program},
              {"renderer", report.renderer},
              {"written_on", report.written_on},
              {"subject", report.subject},
              {"law", report.law},
              {"timed_by", report.timed_by},
              {"rounds", report.rounds},
              {"held_out_lights", report.held_out_lights},
              {"wish", as_json(report.wish)},
              {"scenes", Json::array()}};
    for (const auto& scene : report.scenes)
        json["scenes"].push_back(as_json(scene));
    return json.dump(1) + "\n";
}

} // namespace experiment::cost
