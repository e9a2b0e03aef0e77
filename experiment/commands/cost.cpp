// pairlight cost: what every method and its dials cost, how far they are off, and which to take.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/model_options.h"
#include "experiment/commands/output_folder.h"
#include "experiment/cost/contestants.h"
#include "experiment/cost/cost_page.h"
#include "experiment/cost/earlier_runs.h"
#include "experiment/cost/measure_scene.h"
#include "experiment/cost/read_cost.h"
#include "experiment/models.h"
#include "experiment/progress.h"
#include "experiment/read_study.h"
#include "experiment/session/clock.h"
#include "experiment/study_folder.h"
#include "experiment/text_files.h"
#include "renderer/gpu/context.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace experiment::commands {

namespace fs = std::filesystem;

using protocols::Rendering;
using protocols::Variant;

namespace {

struct Options {
    std::string subject;
    std::vector<std::string> scenes, variants;
    // for a model without a study
    protocols::Scene look{.material = "marble"};
    std::optional<std::array<double, 3>> to_light; ///< under three lights without it
    renderer::geometry::Holes holes = renderer::geometry::Holes::Refuse;
    int frame_size = 480;
    std::string time = "auto";

    std::string law;
    cost::MeasureOptions measure;
    std::string error = "law";
    double tolerance = 0, budget_ms = 0;
    std::string out;
    std::vector<std::string> earlier;
    Voice voice;
};

Variant lit_from(const char* id, const char* label, std::array<double, 3> direction) {
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    for (auto& coordinate : direction)
        coordinate /= length;
    return {.id = {id}, .label = label, .lights = {{.to_light = direction}}};
}

/// A study of one scene, under three lights or the one that was asked for.
LoadedStudy study_of_model(const Options& options) {
    LoadedStudy loaded{.folder = {"."}, .study = {}, .sha256 = {}};
    auto scene = options.look;
    scene.model = options.subject;
    scene.may_have_holes = options.holes == renderer::geometry::Holes::ByWinding;
    scene.id = {fs::path(options.subject).stem().string()};
    loaded.study.id = loaded.study.title = scene.id.value;
    loaded.study.width = loaded.study.height = options.frame_size;
    loaded.study.scenes = {scene};
    if (options.to_light)
        loaded.study.variants = {lit_from("light", "under the light asked for", *options.to_light)};
    else
        loaded.study.variants = {lit_from("back", "from behind", {0, 0.3, -1}),
                                 lit_from("front", "from the front", {0.3, 0.3, 1}),
                                 lit_from("left", "from the left", {-1, 0.2, 0.2})};
    return loaded;
}

/// What was named, or everything; a name that is not there is an error.
template <class Thing>
std::vector<Thing> chosen(const std::vector<Thing>& all,
                          const std::vector<std::string>& names,
                          const std::string& subject,
                          const char* kind) {
    std::vector<Thing> found;
    for (const auto& thing : all)
        if (names.empty() || std::ranges::find(names, thing.id.value) != names.end())
            found.push_back(thing);
    for (const auto& name : names)
        if (std::ranges::none_of(all, [&](const Thing& thing) { return thing.id.value == name; }))
            throw CommandError(fmt::format("{}: no {} \"{}\"", subject, kind, name));
    return found;
}

/// That of the study's first condition that has one, if nobody says.
std::string law_for(const Options& options, const protocols::Study& study) {
    if (!options.law.empty())
        return options.law;
    for (const auto& condition : study.conditions)
        if (const auto* rendering = std::get_if<Rendering>(&condition.source))
            if (const auto law = rendering->dials.find("law"); law != rendering->dials.end())
                return std::get<std::string>(law->second);
    return "physical";
}

fs::path folder_for(const Options& options, const LoadedStudy& loaded) {
    if (!options.out.empty())
        return options.out;
    return is_study(options.subject) ? loaded.folder.cost() : fs::path(loaded.study.id + "-cost");
}

cost::Wish wish_of(const Options& options) {
    cost::Wish wish{.error = *cost::error_kind(options.error)};
    if (options.tolerance > 0)
        wish.tolerance = options.tolerance;
    if (options.budget_ms > 0) {
        wish.budget_ms = options.budget_ms;
        wish.tolerance.reset();
    }
    return wish;
}

void refuse_what_changes_nothing(const Options& options, const Command& command) {
    if (!options.earlier.empty())
        command.expect_not_given({"--scene", "--variant", "--material", "--diameter-mm",
                                  "--turn-degrees", "--up", "--to-light", "--frame-size", "--holes",
                                  "--methods", "--presets", "--decimate", "--law", "--size",
                                  "--samples", "--rounds", "--time", "--held-out",
                                  "--reference-seconds"},
                                 "nothing is measured with --from, expected one of the two");
    if (is_study(options.subject))
        command.expect_not_given({"--material", "--diameter-mm", "--turn-degrees", "--up",
                                  "--to-light", "--frame-size", "--holes"},
                                 "is for a model; " + options.subject +
                                     " is a study, which says it itself");
    if (options.measure.sweep.presets_only)
        command.expect_not_given({"--decimate"},
                                 "--presets measures no simplified mesh, expected one of the two");
}

void check(const Options& options, const std::vector<protocols::Scene>& scenes) {
    expect_direction("--up", options.look.up);
    if (options.to_light)
        expect_direction("--to-light", *options.to_light);
    if (options.tolerance > 0 && options.budget_ms > 0)
        throw CommandError("--tolerance and --frame-budget: expected one of them");
    for (const auto& scene : scenes)
        if (scene.model.empty())
            throw CommandError(
                fmt::format("{}: scene \"{}\" has no model, expected one to measure on",
                            options.subject, scene.id.value));
}

/// Earlier runs in one report, chosen from again.
cost::CostReport put_together(const Options& options, const std::string& subject) {
    std::vector<cost::EarlierRun> runs;
    for (const auto& file : options.earlier) {
        if (fs::is_directory(file))
            throw CommandError(fmt::format("--from {}: is a folder; name its cost.json", file));
        runs.push_back({file, value_or_stop(read_text_file(file).and_then([&](const auto& text) {
                            return cost::parse_cost(text, file);
                        }))});
    }
    value_or_stop(cost::expect_subject(runs, subject, options.subject));
    auto whole = value_or_stop(cost::together(runs));
    cost::choose_again(whole, wish_of(options));
    return whole;
}

/// What was measured takes long: a report is replaced by what was made from it, not by another.
void keep_other_measurements(const Options& options, const fs::path& folder) {
    const auto there = folder / "cost.json";
    std::error_code ignored;
    if (fs::exists(there, ignored) && std::ranges::none_of(options.earlier, [&](const auto& file) {
            return fs::equivalent(file, there, ignored);
        }))
        throw CommandError(
            fmt::format("{}: holds measurements that are in none of --from and would "
                        "be lost; name another folder with --out",
                        there.string()));
    for (const auto* made_from_it : {"cost.csv", "cost.html"})
        expect_not_lost(folder / made_from_it, {options.earlier.begin(), options.earlier.end()});
}

void tell(const Options& options, const fs::path& folder, const cost::CostReport& report) {
    fmt::print("{}", cost::cost_text(report));
    options.voice.remark(value_or_stop(cost::write_cost(folder, report)).string());
}

void run(Options& options, const Command& command) {
    refuse_what_changes_nothing(options, command);
    const auto loaded = is_study(options.subject) ? value_or_stop(read_study(options.subject))
                                                  : study_of_model(options);
    const auto scenes = chosen(loaded.study.scenes, options.scenes, options.subject, "scene");
    const auto variants =
        chosen(shown_variants(loaded.study), options.variants, options.subject, "variant");
    check(options, scenes);
    const auto folder = folder_for(options, loaded);
    if (!options.earlier.empty()) {
        const auto report = put_together(options, loaded.study.title);
        keep_other_measurements(options, folder);
        return tell(options, folder, report);
    }
    options.measure.sweep.law = law_for(options, loaded.study);
    options.measure.wish = wish_of(options);
    options.measure.truth.study =
        is_study(options.subject) ? loaded.folder : StudyFolder{folder / "study"};
    options.measure.truth.own = folder / "reference";
    // neither a folder that cannot be written nor a slip in the names should wait for the models
    expect_writable(folder);
    value_or_stop(cost::settings_of(options.measure.sweep));

    const auto context = value_or_stop(renderer::gpu::Context::surfaceless());
    options.measure.by_processor =
        options.time == "processor" ||
        (options.time == "auto" && renderer::gpu::draws_on_the_processor());
    cost::CostReport report{.program = PAIRLIGHT_PROGRAM_VERSION,
                            .renderer = renderer::gpu::description(),
                            .written_on = session::local_date(session::SystemClock().wall()),
                            .subject = loaded.study.title,
                            .law = options.measure.sweep.law,
                            .timed_by = options.measure.by_processor ? "processor" : "clock",
                            .rounds = options.measure.rounds,
                            .held_out_lights = options.measure.held_out_lights,
                            .wish = options.measure.wish,
                            .scenes = {}};
    ProgressBar bar("cost", !options.voice.quiet);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        auto model = value_or_stop(load_model(scenes[i], loaded.folder));
        report.scenes.push_back(value_or_stop(cost::measure_scene(
            loaded.study, scenes[i], variants, std::move(model), options.measure,
            [&](const std::string&, double done) {
                bar.update((static_cast<double>(i) + done) / static_cast<double>(scenes.size()));
            })));
    }
    tell(options, folder, report);
}

void add_model_options(Command& command, const std::shared_ptr<Options>& options) {
    add_look(command, options->look);
    command
        .add_option("--to-light", options->to_light,
                    "For a model: toward the light, x right, y up, z toward the viewer; without it "
                    "three lights, from behind, the front and the left")
        .within(-1e9, 1e9);
    add_holes(command, options->holes);
    command
        .add_option("--frame-size", options->frame_size,
                    "For a model: pixels along an edge of the frames that are timed")
        .within(8, 8192)
        .shows_default();
}

void add_measuring_options(Command& command, const std::shared_ptr<Options>& options) {
    auto& measure = options->measure;
    command.add_option("--methods", measure.sweep.methods, "Methods to measure; without it, all");
    command.add_flag("--presets", measure.sweep.presets_only, "Every method at its presets only");
    command
        .add_option("--decimate", measure.sweep.one_of,
                    "Simplified meshes on which the presets are measured too: one of so many "
                    "triangles is kept; 1: only the mesh as it is")
        .within(1, 1000)
        .shows_default();
    command
        .add_option("--law", options->law,
                    "Of attenuation; without it, that of the study's conditions")
        .one_of({"paper", "physical"});
    command
        .add_option("--size", measure.size,
                    "Pixels along the longer edge of the pictures that are compared")
        .within(8, 8192)
        .shows_default();
    command.add_option("--samples", measure.samples, "Of each of their pixels")
        .within(1, 256)
        .shows_default();
    command.add_option("--rounds", measure.rounds, "Of timed frames")
        .within(1, 1000)
        .shows_default();
    command
        .add_option("--time", options->time,
                    "How frames are timed: by the processor's time, which others on the machine do "
                    "not change, or by the clock; auto: the first where the processor draws")
        .one_of({"auto", "processor", "clock"})
        .shows_default();
    command
        .add_option("--held-out", measure.held_out_lights,
                    "Directions of light under which thickness is compared")
        .within(1, 1000)
        .shows_default();
    command
        .add_option("--reference-seconds", measure.truth.seconds,
                    "For each path-traced picture that is not there yet; 0: do without")
        .within(0.0, 1e6)
        .shows_default();
}

} // namespace

void add_cost(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "cost", "Speed against error of every method and its dials, and the setting to take");
    command
        .add_option("STUDY|MODEL", options->subject,
                    "A study; or a model file, a model's name or a body")
        .not_blank("a study's folder or file, or a model file, a model's name or a body")
        .required();
    command.add_option("--scene", options->scenes, "Scenes of the study; without it, all");
    command.add_option("--variant", options->variants, "Variants to measure; without it, all");
    add_model_options(command, options);
    add_measuring_options(command, options);
    command
        .add_option("--error", options->error,
                    "Which error the choice goes by: of thickness, of the picture under the same "
                    "law, or against the path-traced one (at equal brightness, or fitted)")
        .one_of({"thickness", "law", "reference", "fitted"})
        .shows_default();
    command
        .add_option("--tolerance", options->tolerance,
                    "Choose the cheapest setting with at most this error, 0.05 without it")
        .within(1e-6, 10.0);
    command
        .add_option("--frame-budget", options->budget_ms,
                    "Choose the least error of the settings that draw a frame in so many ms")
        .within(1e-3, 1e6);
    command
        .add_option("--out", options->out,
                    "Folder to write; without it, STUDY/cost or <model>-cost")
        .not_standard_output();
    command.add_option(
        "--from", options->earlier,
        "cost.json of earlier runs: put together and chosen from again; nothing is measured");
    add_voice(command, options->voice);
    command.runs([options, command] { run(*options, command); });
}

} // namespace experiment::commands
