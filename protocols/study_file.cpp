// Reads a study, strictly, so that a slip of the pen cannot change an experiment.
// The form is documented in docs/study-file.md.
#include "protocols/material_section.h"
#include "protocols/section.h"
#include "protocols/session_file.h"
#include "protocols/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>

namespace protocols {

namespace {

constexpr std::size_t most_lights = 8;

/// Notes ids that come twice among tables of one kind.
template <class Item>
void expect_own_ids(const std::vector<Item>& items, std::string_view kind, Problems& problems) {
    std::map<std::string, int> lines;
    for (const auto& item : items)
        if (const auto [earlier, is_new] = lines.emplace(item.id.value, item.line); !is_new)
            problems.note(item.line,
                          fmt::format("id '{}' is already that of the {} at line {}, expected a "
                                      "name of its own",
                                      item.id.value, kind, earlier->second));
}

void read_head(Section section, Study& study) {
    study.id = section.id();
    study.title = section.text("title");
    study.question = section.text("question");
    study.seed = static_cast<std::uint64_t>(
        section.whole("seed", {0, std::numeric_limits<std::int64_t>::max()}));
    study.width = static_cast<int>(section.whole("width", {16, 16384}));
    study.height = static_cast<int>(section.whole("height", {16, 16384}));
    section.expect_nothing_else();
}

std::optional<DialValue> dial_value(const Node& node) {
    if (const auto* whole = std::get_if<std::int64_t>(&node.value))
        return *whole;
    if (const auto* number = std::get_if<double>(&node.value))
        return *number;
    if (const auto* text = std::get_if<std::string>(&node.value))
        return *text;
    return std::nullopt;
}

/// All keys that nothing else has asked for are dials: what they may be, the method knows.
Dials read_dials(Section& section) {
    Dials dials;
    for (const auto& [key, line, node] : section.rest())
        if (const auto value = dial_value(node))
            dials.emplace(key, *value);
        else
            section.refuse(key, "a number, or text in quotes");
    return dials;
}

/// [condition.k.<scene>]: coefficients of the condition's own, as `pairlight fit` finds them.
std::map<std::string, ShadingCoefficients> read_own_coefficients(Section& section) {
    std::map<std::string, ShadingCoefficients> own;
    auto scenes = section.table("k", false);
    for (const auto& scene : scenes.rest()) {
        auto table = scenes.table(scene.key, true);
        const auto term = [&](std::string_view name) {
            if (!table.has(name))
                table.note(name, fmt::format("[condition.k.{}] has no '{}', expected three numbers",
                                             scene.key, name));
            return table.triple(name, {0, 1e6}, {});
        };
        own[scene.key] = {term("ambient"), term("diffuse"), term("specular"), term("scatter")};
        table.expect_nothing_else();
    }
    return own;
}

/// A dial that does nothing would let a study claim a difference that is not there.
Rendering read_rendering(Section& section, const KnownNames& known) {
    Rendering rendering;
    rendering.method = section.one_of("method", known.methods);
    rendering.k = read_own_coefficients(section);
    const auto given = read_dials(section);
    if (std::find(known.methods.begin(), known.methods.end(), rendering.method) ==
        known.methods.end())
        return rendering;
    if (auto dials = known.complete(rendering.method, given))
        rendering.dials = std::move(*dials);
    else
        section.note(dials.error().dial,
                     fmt::format("{} in [[condition]] {}", dials.error().dial, dials.error().what));
    return rendering;
}

void read_own_images(Section& section) {
    section.one_of("source", {"images"});
    if (section.has("method"))
        section.note("method", "a condition with both 'method' and 'source', expected one: its "
                               "pictures are rendered, or lie there already");
    for (const auto& entry : section.rest())
        section.note(entry.key, fmt::format("{} in [[condition]] is no dial of source \"images\", "
                                            "which has none",
                                            entry.key));
}

/// What is not what its name says has to say so wherever people read it.
void honour_caveat(Section& section,
                   const KnownNames& known,
                   const std::string& method,
                   Condition& condition) {
    const auto caveat = known.caveats.find(method);
    if (caveat == known.caveats.end() || condition.label.find(caveat->second) != std::string::npos)
        return;
    if (section.has("label"))
        section.refuse("label",
                       fmt::format("the word \"{}\" in it, for that is what method '{}' is",
                                   caveat->second, method));
    condition.label += fmt::format(" ({})", caveat->second);
}

Condition read_condition(Section section, const KnownNames& known) {
    Condition condition;
    condition.line = section.line();
    condition.id.value = section.id();
    condition.label = section.text("label", condition.id.value);
    if (section.has("source")) {
        condition.source = OwnImages{};
        read_own_images(section);
    } else if (section.has("method")) {
        auto rendering = read_rendering(section, known);
        honour_caveat(section, known, rendering.method, condition);
        condition.source = std::move(rendering);
    } else {
        section.note("id", fmt::format("[[condition]] '{}' has no 'method', expected one of {}, or "
                                       "source = \"images\"",
                                       condition.id.value, fmt::join(known.methods, ", ")));
        section.rest();
    }
    return condition;
}

/// What is not rendered needs no model, no material and no light.
enum class Pictures { Rendered, MadeElsewhere };

void read_size(Section& section, Scene& scene) {
    section.number("diameter_mm", {0.001, 1e6}, scene.diameter_mm);
    if (!section.has("mm_per_unit"))
        return;
    scene.mm_per_unit = 1;
    section.number("mm_per_unit", {1e-9, 1e9}, *scene.mm_per_unit);
    if (section.has("diameter_mm"))
        section.note("mm_per_unit", "a scene with both 'diameter_mm' and 'mm_per_unit', expected "
                                    "one: either gives the model's size");
}

// Rendered pictures have one size, for what they cost to be compared.
void read_picture_size(Section& section, Scene& scene, Pictures pictures) {
    const bool has_width = section.has("width"), has_height = section.has("height");
    if (!has_width && !has_height)
        return;
    const auto* given = has_width ? "width" : "height";
    if (pictures == Pictures::Rendered)
        section.refuse(given, "no such key: a study that renders has the size of all its pictures "
                              "in [study]");
    else if (has_width != has_height)
        section.refuse(given, fmt::format("a '{}' beside it: both or neither",
                                          has_width ? "height" : "width"));
    else
        scene.size = PictureSize{static_cast<int>(section.whole("width", {16, 16384})),
                                 static_cast<int>(section.whole("height", {16, 16384}))};
}

/// `materials`: the names a scene may use.
Scene read_scene(Section section, const std::vector<std::string>& materials, Pictures pictures) {
    const auto missing =
        pictures == Pictures::Rendered ? std::nullopt : std::optional<std::string>("");
    Scene scene;
    scene.line = section.line();
    scene.id.value = section.id();
    if (scene.id.value == "manifest.json")
        section.refuse("id", "another name: the stimuli's manifest is called that");
    scene.label = section.text("label", scene.id.value);
    scene.model = section.text("model", missing);
    section.number("turn_degrees", {-360, 360}, scene.turn_degrees);
    section.number("elevation_degrees", {-90, 90}, scene.elevation_degrees);
    scene.up = section.direction("up", scene.up);
    read_size(section, scene);
    read_picture_size(section, scene, pictures);
    scene.material = section.one_of("material", materials, missing);
    scene.may_have_holes = section.one_of("holes", {"refuse", "winding"}, "refuse") == "winding";
    section.expect_nothing_else();
    return scene;
}

std::array<double, 3> to_light(Section& section, Pictures pictures) {
    return section.direction("to_light", pictures == Pictures::Rendered
                                             ? std::nullopt
                                             : std::optional(Light{}.to_light));
}

Light read_light(Section section) {
    Light light;
    if (section.has("position_mm")) {
        light.kind = Light::Kind::Near;
        light.position_mm = section.triple("position_mm", {-1e6, 1e6}, light.position_mm);
        section.number("reference_mm", {0.001, 1e6}, light.reference_mm);
        if (section.has("to_light"))
            section.note("to_light",
                         "a light with both 'to_light' and 'position_mm', expected one: "
                         "it is far away, or near");
    } else {
        light.to_light = to_light(section, Pictures::Rendered);
    }
    light.intensity = section.triple("intensity", {0, 1e6}, light.intensity);
    section.expect_nothing_else();
    return light;
}

Variant read_variant(Section section, Pictures pictures) {
    Variant variant;
    variant.line = section.line();
    variant.id.value = section.id();
    variant.label = section.text("label", variant.id.value);
    if (section.has("light")) {
        variant.lights.clear();
        for (auto& light : section.tables("light"))
            variant.lights.push_back(read_light(std::move(light)));
        if (section.has("to_light"))
            section.note("to_light",
                         "a variant with both 'to_light' and [[variant.light]], expected "
                         "one: a single light, or several");
        if (variant.lights.empty() || variant.lights.size() > most_lights)
            section.note("light", fmt::format("{} lights in [[variant]], expected 1 to {}",
                                              variant.lights.size(), most_lights));
    } else {
        variant.lights = {{.to_light = to_light(section, pictures)}};
    }
    section.expect_nothing_else();
    return variant;
}

/// Coefficients for a scene there is not would change nothing, unnoticed.
void expect_scenes_of_coefficients(const Study& study, Problems& problems) {
    for (const auto& condition : study.conditions)
        if (const auto* rendering = std::get_if<Rendering>(&condition.source))
            for (const auto& [scene, k] : rendering->k)
                if (std::none_of(study.scenes.begin(), study.scenes.end(),
                                 [&](const Scene& one) { return one.id.value == scene; }))
                    problems.note(condition.line,
                                  fmt::format("condition '{}' has coefficients for '{}', expected "
                                              "the id of a scene",
                                              condition.id.value, scene));
}

Study read_study(const Table& root, const KnownNames& known, Problems& problems) {
    Study study;
    Section file(root, 1, "the study file", problems);
    read_head(file.table("study", true), study);
    read_session_tables(file, study);
    for (auto& section : file.tables("condition"))
        study.conditions.push_back(read_condition(std::move(section), known));
    const auto pictures =
        std::any_of(study.conditions.begin(), study.conditions.end(),
                    [](const Condition& condition) {
                        return std::holds_alternative<Rendering>(condition.source);
                    })
            ? Pictures::Rendered
            : Pictures::MadeElsewhere;
    auto materials = known.materials;
    for (auto& section : file.tables("material")) {
        study.materials.push_back(read_material(std::move(section), known));
        materials.push_back(study.materials.back().id.value);
    }
    for (auto& section : file.tables("scene"))
        study.scenes.push_back(read_scene(std::move(section), materials, pictures));
    for (auto& section : file.tables("variant"))
        study.variants.push_back(read_variant(std::move(section), pictures));
    file.expect_nothing_else();

    expect_scenes_of_coefficients(study, problems);
    expect_own_ids(study.conditions, "condition", problems);
    expect_own_ids(study.materials, "material", problems);
    expect_own_ids(study.scenes, "scene", problems);
    expect_own_ids(study.variants, "variant", problems);
    expect_known_conditions(file, study);
    if (problems.first())
        return study; // what follows may only be missing because it could not be read
    if (study.conditions.size() < (study.plan.reference ? 3 : 2))
        problems.note(study.conditions.empty() ? 1 : study.conditions.front().line,
                      fmt::format("{} [[condition]] in this study, expected at least 2 to compare",
                                  study.conditions.size()));
    if (study.scenes.empty())
        problems.note(1, "0 [[scene]] in this study, expected at least 1 to show");
    return study;
}

} // namespace

Expected<Study>
parse_study(std::string_view text, std::string_view file_name, const KnownNames& known) {
    const auto document = read_document(text, file_name);
    if (!document)
        return tl::unexpected(document.error());
    Problems problems(file_name);
    auto study = read_study(*document, known, problems);
    if (problems.first())
        return tl::unexpected(*problems.first());
    return study;
}

} // namespace protocols
