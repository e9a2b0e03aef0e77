// Optional members are written when they are there; nothing stands for "not measured".
#include "experiment/cost/cost_files.h"

#include "experiment/cost/cost_figures.h"
#include "experiment/tables.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace experiment::cost {

namespace {

using Json = nlohmann::ordered_json;
using renderer::cost::Spread;

constexpr int form_version = 2; // 2: every row has its own mesh

std::string number(std::optional<double> value) {
    return value && !std::isnan(*value) ? fmt::format("{:.6g}", *value) : "";
}

/// What a cost report cannot hold; says so itself, as the library's own complaints do.
struct Misfit : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A number of things, whole: the library by itself takes -5 and 1.7 for one.
template <class Whole>
Whole count(const Json& json, const char* key) {
    const auto& value = json.at(key);
    if (!value.is_number_unsigned() ||
        value.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
        throw Misfit(fmt::format("{} is {}, expected a whole number from 0", key, value.dump()));
    return value.get<Whole>();
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

Spread spread(const Json& json, const char* key) {
    const auto& value = json.at(key);
    const Spread spread{value.at("lower"), value.at("median"), value.at("upper")};
    if (!(spread.lower >= 0 && spread.lower <= spread.median && spread.median <= spread.upper))
        throw Misfit(
            fmt::format("{} is {}, expected 0 <= lower <= median <= upper", key, value.dump()));
    return spread;
}

/// Absent, or a finite number from 0: times, errors and changes are no less.
std::optional<double> amount(const Json& json, const char* key) {
    const auto value = find<double>(json, key);
    if (value && !(*value >= 0 && *value < 1e30)) // no figure has room for more
        throw Misfit(
            fmt::format("{} is {}, expected a number from 0 to 1e30", key, json.at(key).dump()));
    return value;
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
    return {amount(json, "law"),
            amount(json, "reference"),
            amount(json, "fitted"),
            amount(json, "as_drawn"),
            amount(json, "flip"),
            find<std::string>(json, "decision").value_or(""),
            amount(json, "predicted_change"),
            amount(json, "measured_change")};
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

Row row_of(const Json& json) {
    Row row{.method = json.at("method"),
            .label = json.at("label"),
            .dials = json.at("dials"),
            .setting = json.at("setting"),
            .vertices = count<std::size_t>(json, "vertices"),
            .triangles = count<std::size_t>(json, "triangles"),
            .mesh_bytes = count<std::size_t>(json, "mesh_bytes"),
            .precompute_seconds = amount(json, "precompute_seconds"),
            .bytes_per_vertex = count<std::size_t>(json, "bytes_per_vertex"),
            .bytes_per_light = count<std::size_t>(json, "bytes_per_light"),
            .frame_ms = spread(json, "frame_ms"),
            .resting_ms = spread(json, "resting_ms"),
            .to_bare = spread(json, "to_bare"),
            .clock_ms = json.at("clock_ms"),
            .thickness = amount(json, "thickness"),
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
            json["front"][std::string(name_of(kind))] = front_of(scene, i, kind);
    return json;
}

LightCase light_case(const Json& json) {
    LightCase light{json.at("id"),
                    json.at("label"),
                    count<int>(json, "width"),
                    count<int>(json, "height"),
                    amount(json, "noise_floor"),
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
                    .vertices = count<std::size_t>(json, "vertices"),
                    .triangles = count<std::size_t>(json, "triangles"),
                    .frame_width = count<int>(json, "frame_width"),
                    .frame_height = count<int>(json, "frame_height"),
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
    if (report.scenes.empty())
        return "no scene in it; run `pairlight cost` again";
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
        if (!kind)
            throw Misfit(
                fmt::format("wish.error is {}, expected thickness, law, reference or fitted",
                            wish.at("error").dump()));
        CostReport report{
            .program = json.at("program"),
            .renderer = json.at("renderer"),
            .written_on = json.at("written_on"),
            .subject = json.at("subject"),
            .law = json.at("law"),
            .timed_by = json.at("timed_by"),
            .rounds = count<int>(json, "rounds"),
            .held_out_lights = count<int>(json, "held_out_lights"),
            .wish = {*kind, find<double>(wish, "tolerance"), find<double>(wish, "budget_ms")},
            .scenes = {}};
        for (const auto& scene : json.at("scenes"))
            report.scenes.push_back(scene_cost(scene));
        if (const auto wrong = wrong_places(report); !wrong.empty())
            return tl::unexpected(fmt::format("{}: {}", file_name, wrong));
        return report;
    } catch (const Misfit& misfit) {
        return tl::unexpected(
            fmt::format("{}: {}; run `pairlight cost` again", file_name, misfit.what()));
    } catch (const Json::exception& error) {
        return tl::unexpected(fmt::format("{}: not a cost report: {}; remove it, or run `pairlight "
                                          "cost` again",
                                          file_name, error.what()));
    }
}

} // namespace experiment::cost
