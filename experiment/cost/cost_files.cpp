// Optional members are written when they are there; nothing stands for "not measured".
#include "experiment/cost/cost_files.h"

#include "experiment/tables.h"
#include "renderer/cost/pareto.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace experiment::cost {

namespace {

using Json = nlohmann::ordered_json;
using renderer::cost::Spread;

constexpr int form_version = 1;

std::string number(std::optional<double> value) {
    return value && !std::isnan(*value) ? fmt::format("{:.6g}", *value) : "";
}

std::vector<std::size_t> front(const SceneCost& scene, std::size_t light, ErrorKind kind) {
    std::vector<renderer::cost::Tradeoff> all;
    for (const auto& row : scene.rows)
        all.push_back({row.frame_ms.median, error_of(row, light, kind)});
    return renderer::cost::pareto_front(all);
}

template <class T>
void add(Json& json, const char* key, const std::optional<T>& value) {
    if (value)
        json[key] = *value;
}

template <class T>
std::optional<T> find(const Json& json, const char* key) {
    return json.contains(key) ? std::optional<T>(json.at(key).get<T>()) : std::nullopt;
}

Json as_json(const Spread& spread) {
    return {{"lower", spread.lower}, {"median", spread.median}, {"upper", spread.upper}};
}

Spread spread(const Json& json) {
    return {json.at("lower"), json.at("median"), json.at("upper")};
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

LightErrors light_errors(const Json& json) {
    return {find<double>(json, "law"),
            find<double>(json, "reference"),
            find<double>(json, "fitted"),
            find<double>(json, "as_drawn"),
            find<double>(json, "flip"),
            find<std::string>(json, "decision").value_or(""),
            find<double>(json, "predicted_change"),
            find<double>(json, "measured_change")};
}

Json as_json(const Row& row) {
    Json json{{"method", row.method},
              {"label", row.label},
              {"setting", row.setting},
              {"dials", row.dials},
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

Row row_of(const Json& json) {
    Row row{.method = json.at("method"),
            .label = json.at("label"),
            .dials = json.at("dials"),
            .setting = json.at("setting"),
            .precompute_seconds = find<double>(json, "precompute_seconds"),
            .bytes_per_vertex = json.at("bytes_per_vertex"),
            .bytes_per_light = json.at("bytes_per_light"),
            .frame_ms = spread(json.at("frame_ms")),
            .resting_ms = spread(json.at("resting_ms")),
            .to_bare = spread(json.at("to_bare")),
            .clock_ms = json.at("clock_ms"),
            .thickness = find<double>(json, "thickness"),
            .lights = {}};
    for (const auto& light : json.at("lights"))
        row.lights.push_back(light_errors(light));
    return row;
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
            json["front"][std::string(name_of(kind))] = front(scene, i, kind);
    return json;
}

LightCase light_case(const Json& json) {
    LightCase light{json.at("id"),
                    json.at("label"),
                    json.at("width"),
                    json.at("height"),
                    find<double>(json, "noise_floor"),
                    json.at("reference"),
                    {}};
    if (json.contains("choice")) {
        const auto& choice = json.at("choice");
        light.choice = Choice{choice.at("row"), choice.at("why"), choice.at("left_out"),
                              choice.at("predicted"), find<double>(choice, "measured")};
    }
    return light;
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

SceneCost scene_cost(const Json& json) {
    SceneCost scene{.id = json.at("id"),
                    .label = json.at("label"),
                    .model = json.at("model"),
                    .vertices = json.at("vertices"),
                    .triangles = json.at("triangles"),
                    .frame_width = json.at("frame_width"),
                    .frame_height = json.at("frame_height"),
                    .lights = {},
                    .rows = {},
                    .remarks = json.at("remarks")};
    for (const auto& light : json.at("lights"))
        scene.lights.push_back(light_case(light));
    for (const auto& row : json.at("rows"))
        scene.rows.push_back(row_of(row));
    return scene;
}

Json as_json(const Wish& wish) {
    Json json{{"error", std::string(name_of(wish.error))}};
    add(json, "tolerance", wish.tolerance);
    add(json, "budget_ms", wish.budget_ms);
    return json;
}

std::string wrong_places(const CostReport& report) {
    for (const auto& scene : report.scenes) {
        for (const auto& row : scene.rows)
            if (row.lights.size() != scene.lights.size())
                return "a row has not as many lights as its scene";
        for (const auto& light : scene.lights)
            if (light.choice && light.choice->row >= scene.rows.size())
                return "a choice names a row that is not there";
    }
    return "";
}

std::vector<std::string>
csv_fields(const SceneCost& scene, std::size_t i, std::size_t r, const CostReport& report) {
    const auto& light = scene.lights[i];
    const auto& row = scene.rows[r];
    const auto& errors = row.lights[i];
    const auto is_in = [&](ErrorKind kind) -> std::string {
        const auto all = front(scene, i, kind);
        return std::ranges::find(all, r) == all.end() ? "0" : "1";
    };
    return {scene.id,
            light.id,
            row.method,
            row.setting,
            number(row.precompute_seconds),
            std::to_string(row.bytes_per_vertex),
            std::to_string(row.bytes_per_light),
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
    auto text = csv_row({"scene",           "variant",          "method",
                         "setting",         "precompute_s",     "bytes_per_vertex",
                         "bytes_per_light", "frame_ms",         "frame_ms_lower",
                         "frame_ms_upper",  "resting_ms",       "to_phong",
                         "to_phong_lower",  "to_phong_upper",   "clock_ms",
                         "thickness_error", "law_error",        "reference_error",
                         "fitted_error",    "as_drawn_error",   "ldr_flip",
                         "noise_floor",     "front_thickness",  "front_law",
                         "front_reference", "front_fitted",     "chosen_by",
                         "decision",        "predicted_change", "measured_change"});
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

tl::expected<CostReport, std::string> parse_cost(std::string_view text,
                                                 std::string_view file_name) {
    try {
        const auto json = Json::parse(text);
        if (const int form = json.at("form"); form != form_version)
            return tl::unexpected(
                fmt::format("{}: form {}, expected {}; run `pairlight cost` again", file_name, form,
                            form_version));
        const auto& wish = json.at("wish");
        const auto kind = error_kind(wish.at("error").get<std::string>());
        CostReport report{.program = json.at("program"),
                          .renderer = json.at("renderer"),
                          .written_on = json.at("written_on"),
                          .subject = json.at("subject"),
                          .law = json.at("law"),
                          .timed_by = json.at("timed_by"),
                          .rounds = json.at("rounds"),
                          .held_out_lights = json.at("held_out_lights"),
                          .wish = {kind.value_or(ErrorKind::Law), find<double>(wish, "tolerance"),
                                   find<double>(wish, "budget_ms")},
                          .scenes = {}};
        for (const auto& scene : json.at("scenes"))
            report.scenes.push_back(scene_cost(scene));
        if (const auto wrong = wrong_places(report); !wrong.empty())
            return tl::unexpected(fmt::format("{}: {}", file_name, wrong));
        return report;
    } catch (const Json::exception& error) {
        return tl::unexpected(fmt::format("{}: not a cost report: {}", file_name, error.what()));
    }
}

} // namespace experiment::cost
