// The file may be anybody's: every value is looked at before anything is made of it.
#include "experiment/cost/read_cost.h"

#include "experiment/cost/cost_files.h"
#include "experiment/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace experiment::cost {

namespace {

using renderer::cost::Spread;

/// From 0: times, errors and changes are no less.
double amount(const JsonPlace& json) {
    const double value = json.number();
    if (!(value >= 0 && value < 1e30)) // no figure has room for more
        json.refuse("a number from 0 to 1e30");
    return value;
}

std::optional<double> amount_if_there(const JsonPlace& json, const char* key) {
    return json.has(key) ? std::optional(amount(json.at(key))) : std::nullopt;
}

Spread spread(const JsonPlace& json) {
    const Spread spread{amount(json.at("lower")), amount(json.at("median")),
                        amount(json.at("upper"))};
    if (!(spread.lower <= spread.median && spread.median <= spread.upper))
        json.complain(fmt::format("lower, median and upper are {}, {} and {}, expected lower <= "
                                  "median <= upper",
                                  spread.lower, spread.median, spread.upper));
    return spread;
}

std::string one_of(const JsonPlace& json, const char* first, const char* second) {
    auto word = json.text();
    if (word != first && word != second)
        json.refuse(fmt::format("{} or {}", first, second));
    return word;
}

/// Files are named by it; a variant may have none.
std::string id(const JsonPlace& json) {
    auto id = json.text();
    const bool is_name =
        id.size() <= 200 && id != "." && id != ".." && std::ranges::none_of(id, [](char c) {
            return c == '/' || static_cast<unsigned char>(c) < ' ' || c == 0x7F;
        });
    if (!is_name)
        json.refuse("a name that a file may have");
    return id;
}

LightErrors light_errors(const JsonPlace& json) {
    return {amount_if_there(json, "law"),
            amount_if_there(json, "reference"),
            amount_if_there(json, "fitted"),
            amount_if_there(json, "as_drawn"),
            amount_if_there(json, "flip"),
            json.has("decision") ? json.at("decision").text() : "",
            amount_if_there(json, "predicted_change"),
            amount_if_there(json, "measured_change")};
}

Row row_of(const JsonPlace& json) {
    Row row{.method = json.at("method").text(),
            .label = json.at("label").text(),
            .dials = {},
            .setting = json.at("setting").text(),
            .vertices = json.at("vertices").size(),
            .triangles = json.at("triangles").size(),
            .mesh_bytes = json.at("mesh_bytes").size(),
            .precompute_seconds = amount_if_there(json, "precompute_seconds"),
            .bytes_per_vertex = json.at("bytes_per_vertex").size(),
            .bytes_per_light = json.at("bytes_per_light").size(),
            .frame_ms = spread(json.at("frame_ms")),
            .resting_ms = spread(json.at("resting_ms")),
            .to_bare = spread(json.at("to_bare")),
            .clock_ms = amount(json.at("clock_ms")),
            .thickness = amount_if_there(json, "thickness"),
            .lights = {}};
    for (const auto& [name, value] : json.at("dials").members())
        row.dials[name] = value.text();
    for (const auto& light : json.at("lights").elements())
        row.lights.push_back(light_errors(light));
    return row;
}

Choice choice_of(const JsonPlace& json, std::size_t rows) {
    Choice choice{.row = json.at("row").size(),
                  .why = json.at("why").text(),
                  .left_out = json.at("left_out").text(),
                  .predicted = amount(json.at("predicted")),
                  .measured = amount_if_there(json, "measured")};
    if (choice.row >= rows)
        json.at("row").refuse(fmt::format("one of the {} rows, from 0", rows));
    return choice;
}

LightCase light_case(const JsonPlace& json, std::size_t rows) {
    LightCase light{id(json.at("id")),
                    json.at("label").text(),
                    json.at("width").count(),
                    json.at("height").count(),
                    amount_if_there(json, "noise_floor"),
                    json.at("reference").text(),
                    {}};
    if (json.has("choice"))
        light.choice = choice_of(json.at("choice"), rows);
    return light;
}

SceneCost scene_cost(const JsonPlace& json) {
    SceneCost scene{.id = id(json.at("id")),
                    .label = json.at("label").text(),
                    .model = json.at("model").text(),
                    .vertices = json.at("vertices").size(),
                    .triangles = json.at("triangles").size(),
                    .frame_width = json.at("frame_width").count(),
                    .frame_height = json.at("frame_height").count(),
                    .lights = {},
                    .rows = {},
                    .remarks = {}};
    if (scene.id.empty())
        json.at("id").refuse("a scene's name");
    const auto lights = json.at("lights").elements();
    for (const auto& row : json.at("rows").elements()) {
        scene.rows.push_back(row_of(row));
        if (const auto found = scene.rows.back().lights.size(); found != lights.size())
            row.at("lights").complain(fmt::format(
                "a row has the errors under {} lights, expected those under the scene's {}", found,
                lights.size()));
    }
    for (const auto& light : lights)
        scene.lights.push_back(light_case(light, scene.rows.size()));
    for (const auto& remark : json.at("remarks").elements())
        scene.remarks.push_back(remark.text());
    return scene;
}

Wish wish_of(const JsonPlace& json) {
    const auto kind = error_kind(json.at("error").text());
    if (!kind)
        json.at("error").refuse("thickness, law, reference or fitted");
    const Wish wish{*kind, amount_if_there(json, "tolerance"), amount_if_there(json, "budget_ms")};
    if (!wish.tolerance && !wish.budget_ms)
        json.complain("there is neither wish.tolerance nor wish.budget_ms, expected one of them");
    return wish;
}

/// Under one name, the figure of one would be written over that of the other.
void expect_once(const JsonPlace& json,
                 const SceneCost& scene,
                 std::set<std::pair<std::string, std::string>>& seen) {
    for (const auto& light : scene.lights)
        if (!seen.emplace(scene.id, light.id).second)
            json.complain(
                fmt::format("scene \"{}\"{} is there twice, expected it once", scene.id,
                            light.id.empty() ? "" : fmt::format(", variant \"{}\",", light.id)));
}

CostReport cost_report(const JsonPlace& json) {
    if (const auto form = json.at("form"); form.count() != form_version)
        form.refuse(fmt::format("{}", form_version));
    CostReport report{.program = json.at("program").text(),
                      .renderer = json.at("renderer").text(),
                      .written_on = json.at("written_on").text(),
                      .subject = json.at("subject").text(),
                      .law = one_of(json.at("law"), "paper", "physical"),
                      .timed_by = one_of(json.at("timed_by"), "processor", "clock"),
                      .rounds = json.at("rounds").count(),
                      .held_out_lights = json.at("held_out_lights").count(),
                      .wish = wish_of(json.at("wish")),
                      .scenes = {}};
    std::set<std::pair<std::string, std::string>> seen;
    for (const auto& scene : json.at("scenes").elements()) {
        report.scenes.push_back(scene_cost(scene));
        expect_once(scene, report.scenes.back(), seen);
    }
    if (report.scenes.empty())
        json.at("scenes").complain("there is no scene in it");
    return report;
}

} // namespace

tl::expected<CostReport, std::string> parse_cost(std::string_view text,
                                                 std::string_view file_name) {
    return read_json_as(
        text, file_name,
        "expected a cost.json as it was written; run `pairlight cost` again, or take the file away",
        cost_report);
}

} // namespace experiment::cost
