// pairlight reference: a picture by following light, with its error; and the numbers of tables.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/model_options.h"
#include "experiment/commands/reference_energy.h"
#include "experiment/models.h"
#include "experiment/progress.h"
#include "experiment/read_study.h"
#include "experiment/stimuli/lit_scene.h"
#include "experiment/stimuli/reference_file.h"
#include "experiment/stimuli/reference_recipe.h"
#include "experiment/study_folder.h"
#include "renderer/reference/convergence.h"
#include "renderer/reference/energy.h"
#include "renderer/units.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

namespace experiment::commands {

namespace fs = std::filesystem;
namespace reference = renderer::reference;

namespace {

struct Options {
    std::string subject;
    std::string scene, variant;
    // for a model without a study
    protocols::Scene look{.material = "marble"};
    std::array<double, 3> to_light{0, 0.3, -1};
    renderer::geometry::Holes holes = renderer::geometry::Holes::Refuse;
    int size = 480;

    std::string boundary = "matched";
    double roughness = 0.3, anisotropy = 0, sun_degrees = 0;
    reference::StopRule rule;
    double seconds = 0;
    std::uint64_t seed = 1;
    std::string out;
    Voice voice;
};

/// What is to be rendered: a study's scene under a variant, or a model on its own.
struct Subject {
    StudyFolder folder;
    protocols::Study study;
    protocols::Scene scene;
    protocols::Variant variant;
};

Subject study_subject(const Options& options) {
    const auto loaded = value_or_stop(read_study(options.subject));
    const auto& scenes = loaded.study.scenes;
    const auto variants = protocols::shown_variants(loaded.study);
    const auto scene =
        options.scene.empty()
            ? scenes.begin()
            : std::ranges::find(scenes, options.scene, [](const auto& s) { return s.id.value; });
    if (scene == scenes.end())
        throw CommandError(fmt::format("{}: no scene \"{}\"", options.subject, options.scene));
    const auto variant = options.variant.empty()
                             ? variants.begin()
                             : std::ranges::find(variants, options.variant,
                                                 [](const auto& v) { return v.id.value; });
    if (variant == variants.end())
        throw CommandError(fmt::format("{}: no variant \"{}\"", options.subject, options.variant));
    return {loaded.folder, loaded.study, *scene, *variant};
}

Subject model_subject(const Options& options) {
    expect_direction("--to-light", options.to_light);
    expect_direction("--up", options.look.up);
    Subject subject{{"."}, {}, options.look, {}};
    subject.study.width = subject.study.height = options.size;
    subject.scene.model = options.subject;
    subject.scene.may_have_holes = options.holes == renderer::geometry::Holes::ByWinding;
    const auto& l = options.to_light;
    const auto unit = glm::normalize(glm::dvec3(l[0], l[1], l[2]));
    subject.variant.lights = {{.to_light = {unit.x, unit.y, unit.z}}};
    return subject;
}

void report(const Options& options,
            const reference::Film& film,
            const reference::Outcome& outcome) {
    const auto samples = static_cast<std::uint64_t>(film.batches) << film.log2_batch;
    options.voice.remark(fmt::format(
        "{} samples a pixel in {:.1f} s{}; {:.2f} % of the object's pixels within the rule, "
        "standard error {:.3g} % of the mean; {} leaks in {} paths",
        samples, outcome.seconds, outcome.out_of_time ? ", out of time" : "",
        100 * outcome.state.good_share, 100 * outcome.state.relative_error, film.leaks,
        film.paths));
}

void refuse_what_changes_nothing(const Options& options, const Command& command) {
    if (is_study(options.subject))
        command.expect_not_given({"--material", "--diameter-mm", "--turn-degrees", "--up",
                                  "--to-light", "--holes", "--size"},
                                 "is for a model; " + options.subject +
                                     " is a study, which says it itself");
    else
        command.expect_not_given({"--scene", "--variant"},
                                 "is for a study; " + options.subject + " is a model");
}

void run(Options& options, const Command& command) {
    if (options.subject.empty())
        throw CommandError("name a MODEL or a STUDY, or one of slab, half-space, sphere, furnace");
    if (options.out.empty())
        throw CommandError("say where the picture goes: --out FILE.exr");
    if (fs::path(options.out).extension() != ".exr")
        throw CommandError(fmt::format("{}: expected a name that ends in .exr", options.out));
    refuse_what_changes_nothing(options, command);
    if (options.boundary != "rough")
        command.expect_not_given({"--roughness"},
                                 "is of a rough boundary; --boundary is " + options.boundary);
    if (options.seconds > 0)
        options.rule.time_budget = std::chrono::duration<double>(options.seconds);
    const auto subject =
        is_study(options.subject) ? study_subject(options) : model_subject(options);
    const auto model = value_or_stop(load_model(subject.scene, subject.folder));
    for (const auto& remark : model.remarks)
        options.voice.remark(remark);
    const auto scene = value_or_stop(
        stimuli::lit_scene(subject.study, subject.scene, subject.variant, model.mesh));
    const reference::ReferenceSettings settings{
        {*reference::boundary_kind(options.boundary), options.roughness},
        options.anisotropy,
        renderer::from_degrees(options.sun_degrees)};
    const auto picture = value_or_stop(reference::picture_of_scene(model.mesh, scene, settings));
    const double mm = std::cbrt(glm::determinant(glm::dmat3(scene.placement.world_from_model)));
    options.voice.remark(fmt::format(
        "a path would have {:.3g} collisions on average, did nothing absorb",
        mm * reference::expected_collisions(model.mesh, picture.medium, picture.boundary)));
    const auto recipe = stimuli::reference_recipe(subject.study, subject.scene, subject.variant,
                                                  model.record, settings);
    auto film = value_or_stop(
        stimuli::film_to_go_on_with(options.out, recipe, subject.study, options.seed));
    reference::Outcome outcome;
    {
        ProgressBar bar("following light", !options.voice.quiet);
        outcome = value_or_stop(reference::render(
            picture, film, options.rule, {},
            [&](const reference::Progress& progress) { bar.update(progress.fraction); }));
    }
    value_or_stop(stimuli::write_reference(options.out, {film, recipe}));
    report(options, film, outcome);
}

void add_picture_options(Command& command, const std::shared_ptr<Options>& options) {
    command.add_option("MODEL|STUDY", options->subject,
                       "A model file, a model's name or a body; or a study");
    command.add_option("--scene", options->scene, "Of the study; without it, its first");
    command.add_option("--variant", options->variant, "Of the study; without it, its first");
    add_look(command, options->look);
    command
        .add_option("--to-light", options->to_light,
                    "For a model: toward the light, x right, y up, z toward the viewer")
        .within(-1e9, 1e9);
    add_holes(command, options->holes);
    command.add_option("--size", options->size, "For a model: pixels along an edge")
        .within(8, 8192)
        .shows_default();
    command.add_option("--boundary", options->boundary, "What the surface does to light")
        .one_of({"matched", "smooth", "rough"})
        .shows_default();
    command.add_option("--roughness", options->roughness, "GGX alpha of a rough boundary")
        .shows_default();
    command
        .add_option("--anisotropy", options->anisotropy, "Henyey-Greenstein's g, at one sigma_s'")
        .within(-0.999, 0.999)
        .shows_default();
    command
        .add_option("--sun-degrees", options->sun_degrees,
                    "Half-angle of the light; 0: all from one direction")
        .within(0.0, 90.0)
        .shows_default();
}

} // namespace

void add_reference(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "reference", "A picture by following light, as linear EXR with its error; or one number");
    add_picture_options(command, options);
    command
        .add_option("--relative-error", options->rule.relative,
                    "95 % half-width of a pixel over its light that is good enough")
        .within(1e-5, 1.0)
        .shows_default();
    command
        .add_option(
            "--seconds", options->seconds,
            "Stop after so long with the best picture so far; 0: only when it is good enough")
        .within(0.0, 1e9);
    command.add_option("--seed", options->seed, "Seed of the random numbers").shows_default();
    command.add_option("--out", options->out,
                       "The EXR file; one of the same picture is gone on with");
    add_voice(command, options->voice);
    add_reference_energy(command);
    command.runs([options, command] { run(*options, command); });
}

} // namespace experiment::commands
