// pairlight fit: each method at its best, the coefficients with which it comes nearest to given
// pictures, and how near it comes under a light that was held out.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/models.h"
#include "experiment/progress.h"
#include "experiment/read_study.h"
#include "experiment/stimuli/scene_renderer.h"
#include "renderer/gpu/context.h"
#include "renderer/imaging/image_files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace experiment::commands {

namespace fs = std::filesystem;

using protocols::Scene;
using protocols::Variant;
using renderer::LinearRgb;
using stimuli::Fit;

namespace {

struct Options {
    std::string study;
    std::string targets;
    std::vector<std::string> scenes;
    std::string held_out;
    std::string json;
    Voice voice;
};

using Targets = std::map<protocols::VariantId, renderer::imaging::LinearImage>;

Targets read_targets(const Options& options,
                     const LoadedStudy& loaded,
                     const Scene& scene,
                     const std::vector<Variant>& variants,
                     Inputs& inputs) {
    Targets targets;
    for (const auto& variant : variants) {
        const auto file = fs::path(options.targets) / scene.id.value / (variant.id.value + ".exr");
        if (!fs::exists(file))
            throw CommandError(
                fmt::format("{0}: is not there; the reference is made by `pairlight reference {1} "
                            "--scene {2}{3} "
                            "--out {0}`",
                            file.string(), options.study, scene.id.value,
                            variant.id.value.empty() ? "" : " --variant " + variant.id.value));
        inputs.push_back(file);
        auto target = value_or_stop(renderer::imaging::read_exr(file));
        if (target.width != loaded.study.width || target.height != loaded.study.height)
            throw CommandError(fmt::format("{}: {} x {} pixels, expected {} x {} as in the study",
                                           file.string(), target.width, target.height,
                                           loaded.study.width, loaded.study.height));
        targets.emplace(variant.id, std::move(target));
    }
    return targets;
}

std::vector<Fit>
fit_scene(const Options& options, const LoadedStudy& loaded, const Scene& scene, Inputs& inputs) {
    const auto variants = shown_variants(loaded.study);
    const auto targets = read_targets(options, loaded, scene, variants, inputs);
    auto model = value_or_stop(load_model(scene, loaded.folder));
    inputs.push_back(model.file);
    ProgressBar bar(scene.id.value, !options.voice.quiet);
    auto renderer = value_or_stop(stimuli::SceneRenderer::prepare(
        loaded.study, scene, std::move(model), 4, [&](double fraction) { bar.update(fraction); }));
    return value_or_stop(renderer.fit(variants, {options.held_out}, targets));
}

std::array<double, 3> rgb(const LinearRgb& colour) {
    return {static_cast<double>(colour.r), static_cast<double>(colour.g),
            static_cast<double>(colour.b)};
}

nlohmann::ordered_json to_json(const Fit& fit) {
    const auto& k = fit.best.reflectance;
    nlohmann::ordered_json json{{"scene", fit.scene.value},
                                {"condition", fit.condition.value},
                                {"ambient", rgb(k.ambient)},
                                {"diffuse", rgb(k.diffuse)},
                                {"specular", rgb(k.specular)},
                                {"scatter", rgb(k.scatter)},
                                {"training_relMSE", fit.best.training_error.mean()}};
    if (fit.held_out_error)
        json["held_out_relMSE"] = fit.held_out_error->mean();
    for (const auto term : fit.best.absent)
        json["absent"].push_back(std::string(name(term)));
    return json;
}

std::string as_toml(const LinearRgb& colour) {
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", colour.r, colour.g, colour.b);
}

/// Ready to stand behind its [[condition]] in the study file.
std::string as_toml(const Fit& fit) {
    const auto& k = fit.best.reflectance;
    auto text = fmt::format("# condition \"{}\": relMSE {:.4g}", fit.condition.value,
                            fit.best.training_error.mean());
    if (fit.held_out_error)
        text += fmt::format(", under the light held out {:.4g}", fit.held_out_error->mean());
    for (const auto term : fit.best.absent)
        text += fmt::format("; it has no {} term", name(term));
    return text + fmt::format("\n[condition.k.{}]\nambient  = {}\ndiffuse  = {}\nspecular = {}\n"
                              "scatter  = {}\n\n",
                              fit.scene.value, as_toml(k.ambient), as_toml(k.diffuse),
                              as_toml(k.specular), as_toml(k.scatter));
}

void check_names(const Options& options, const LoadedStudy& loaded) {
    const auto variants = shown_variants(loaded.study);
    const auto known = [&](const auto& all, const std::string& id) {
        return std::ranges::any_of(all, [&](const auto& one) { return one.id.value == id; });
    };
    for (const auto& scene : options.scenes)
        if (!known(loaded.study.scenes, scene))
            throw CommandError(fmt::format("{}: no scene \"{}\"", options.study, scene));
    if (!options.held_out.empty() && !known(variants, options.held_out))
        throw CommandError(fmt::format("{}: no variant \"{}\"", options.study, options.held_out));
    if (!options.held_out.empty() && variants.size() < 2)
        throw CommandError("one variant only: with its light held out there is none to fit to");
}

void run(Options& options) {
    const auto loaded = value_or_stop(read_study(options.study));
    check_names(options, loaded);
    if (options.targets.empty())
        options.targets = (loaded.folder.root / "reference").string();
    const auto context = value_or_stop(renderer::gpu::Context::surfaceless());
    auto inputs = files_of(loaded);
    std::string text;
    auto json = nlohmann::ordered_json::array();
    for (const auto& scene : loaded.study.scenes) {
        if (!options.scenes.empty() &&
            std::ranges::find(options.scenes, scene.id.value) == options.scenes.end())
            continue;
        for (const auto& fit : fit_scene(options, loaded, scene, inputs)) {
            text += as_toml(fit);
            json.push_back(to_json(fit));
        }
    }
    if (options.json.empty())
        fmt::print("{}", text);
    else
        deliver(json.dump(1) + "\n", options.json, inputs);
}

} // namespace

void add_fit(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "fit", "The coefficients with which each method comes nearest to the reference");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    command.add_option("--targets", options->targets,
                       "Folder of <scene>/<variant>.exr, linear; without it, STUDY/reference");
    command.add_option("--scene", options->scenes, "Scenes to fit; without it, all");
    command.add_option("--hold-out", options->held_out,
                       "A variant to leave out of the fit and to measure it by");
    command.add_option("--json", options->json,
                       "Write the fits to this file, as JSON; - is standard output");
    add_voice(command, options->voice);
    command.runs([options] { run(*options); });
}

} // namespace experiment::commands
