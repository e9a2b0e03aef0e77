// Scene by scene: the model is loaded and traced once, then lit and drawn under every variant by
// every condition.
#include "experiment/stimuli/render_study.h"

#include "experiment/reference_dials.h"
#include "experiment/stimuli/own_images.h"
#include "experiment/stimuli/recipe.h"
#include "experiment/stimuli/scene_renderer.h"
#include "experiment/text_files.h"
#include "protocols/digest.h"
#include "renderer/expected.h"
#include "renderer/gpu/context.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace experiment::stimuli {

namespace fs = std::filesystem;

using protocols::Condition;
using protocols::Picture;
using protocols::Rendering;
using protocols::Scene;
using protocols::Study;
using protocols::Variant;
using renderer::Expected;

namespace {

bool wanted(const Scene& scene, const RenderOptions& options) {
    return options.only_scenes.empty() ||
           std::ranges::find(options.only_scenes, scene.id.value) != options.only_scenes.end();
}

bool is_rendered(const Condition& condition) {
    return std::holds_alternative<Rendering>(condition.source);
}

/// Whether `file` still holds the bytes that were written.
bool unchanged(const fs::path& file, const std::string& sha256) {
    const auto bytes = read_text_file(file);
    return bytes && protocols::sha256_hexadecimal(*bytes) == sha256;
}

/// One run of `render`: what it works on and what it has done so far.
class Run {
  public:
    Run(const LoadedStudy& loaded, const RenderOptions& options, const RenderProgress& progress)
        : loaded_(loaded), options_(options), progress_(progress) {}

    Expected<RenderSummary> carry_out();

  private:
    const Study& study() const { return loaded_.study; }

    /// Whether the study still has the picture; others leave the manifest.
    bool is_asked_for(const Picture& picture) const;
    Expected<void> check_scene_names() const;
    Expected<void> render_scene(const Scene& scene);
    std::vector<Variant> outdated_variants(const Scene& scene, const ModelRecord& model) const;
    bool up_to_date(const Scene& scene, const Variant& variant, const std::string& recipe) const;
    Expected<void> take_own_images(const Scene& scene);
    Expected<void> save_manifest() const;
    void report(const std::string& what, double of_this_scene) const;

    const LoadedStudy& loaded_;
    const RenderOptions& options_;
    const RenderProgress& progress_;
    Manifest manifest_;
    RenderSummary summary_;
    std::optional<renderer::gpu::Context> context_;
    std::string renderer_;
    std::size_t scenes_done_ = 0;
};

Expected<RenderSummary> Run::carry_out() {
    auto manifest = read_manifest(loaded_.folder);
    if (!manifest)
        return tl::unexpected(manifest.error());
    manifest_ = std::move(*manifest);
    std::erase_if(manifest_.pictures,
                  [&](const auto& entry) { return !is_asked_for(entry.first); });
    if (auto named = check_scene_names(); !named)
        return tl::unexpected(named.error());
    if (std::ranges::any_of(study().conditions, is_rendered)) {
        auto context = renderer::gpu::Context::surfaceless();
        if (!context)
            return tl::unexpected(context.error());
        context_ = std::move(*context);
        renderer_ = renderer::gpu::description();
    }
    for (const auto& scene : study().scenes) {
        if (!wanted(scene, options_))
            continue;
        if (auto done = take_own_images(scene); !done)
            return tl::unexpected(done.error());
        if (auto done = render_scene(scene); !done)
            return tl::unexpected(done.error());
        if (auto saved = save_manifest(); !saved)
            return tl::unexpected(saved.error());
        ++scenes_done_;
    }
    return summary_;
}

bool Run::is_asked_for(const Picture& picture) const {
    const auto has = [](const auto& all, const auto& id) {
        return std::ranges::any_of(all, [&](const auto& one) { return one.id == id; });
    };
    return has(study().scenes, picture.scene) && has(shown_variants(study()), picture.variant) &&
           has(study().conditions, picture.condition);
}

Expected<void> Run::check_scene_names() const {
    for (const auto& name : options_.only_scenes)
        if (std::ranges::none_of(study().scenes,
                                 [&](const Scene& scene) { return scene.id.value == name; }))
            return tl::unexpected(
                fmt::format("{}: has no scene \"{}\"", loaded_.folder.study_file().string(), name));
    return {};
}

Expected<void> Run::render_scene(const Scene& scene) {
    if (!context_)
        return {};
    auto model = load_model(scene, loaded_.folder);
    if (!model)
        return tl::unexpected(fmt::format("{}:{}: scene \"{}\": {}",
                                          loaded_.folder.study_file().string(), scene.line,
                                          scene.id.value, model.error()));
    const auto variants = outdated_variants(scene, model->record);
    const auto rendered_conditions = std::ranges::count_if(study().conditions, is_rendered);
    const auto all = shown_variants(study()).size();
    summary_.up_to_date += static_cast<int>((all - variants.size()) * rendered_conditions);
    if (variants.empty())
        return {};

    auto scene_renderer = SceneRenderer::prepare(
        study(), scene, std::move(*model), options_.samples,
        [&](double fraction) { report("thickness of " + scene.id.value, 0.7 * fraction); });
    if (!scene_renderer)
        return tl::unexpected(
            fmt::format("scene \"{}\": {}", scene.id.value, scene_renderer.error()));
    for (std::size_t i = 0; i < variants.size(); ++i) {
        report("pictures of " + scene.id.value,
               0.7 + 0.3 * static_cast<double>(i) / static_cast<double>(variants.size()));
        auto records = scene_renderer->render(variants[i], loaded_.folder);
        if (!records)
            return tl::unexpected(records.error());
        const auto cooked = recipe(study(), scene, variants[i], scene_renderer->model(), renderer_,
                                   options_.samples);
        for (auto& [picture, record] : *records) {
            record.recipe = cooked;
            record.renderer = record.dials.at("method") == reference_method
                                  ? path_tracer_beside(renderer_)
                                  : renderer_;
            manifest_.pictures[picture] = std::move(record);
            ++summary_.rendered;
        }
    }
    for (const auto& remark : scene_renderer->remarks())
        summary_.remarks.push_back(scene.id.value + ": " + remark);
    return {};
}

std::vector<Variant> Run::outdated_variants(const Scene& scene, const ModelRecord& model) const {
    std::vector<Variant> outdated;
    for (const auto& variant : shown_variants(study()))
        if (!up_to_date(scene, variant,
                        recipe(study(), scene, variant, model, renderer_, options_.samples)))
            outdated.push_back(variant);
    return outdated;
}

bool Run::up_to_date(const Scene& scene, const Variant& variant, const std::string& recipe) const {
    return std::ranges::all_of(study().conditions, [&](const Condition& condition) {
        const Picture picture{scene.id, variant.id, condition.id};
        const auto found = manifest_.pictures.find(picture);
        return !is_rendered(condition) ||
               (found != manifest_.pictures.end() && found->second.recipe == recipe &&
                unchanged(png_file(loaded_.folder, picture), found->second.png_sha256) &&
                fs::exists(exr_file(loaded_.folder, picture)));
    });
}

Expected<void> Run::take_own_images(const Scene& scene) {
    for (const auto& variant : shown_variants(study()))
        for (const auto& condition : study().conditions) {
            if (is_rendered(condition))
                continue;
            const Picture picture{scene.id, variant.id, condition.id};
            auto record = inspect_own_image(loaded_, picture);
            if (!record)
                return tl::unexpected(record.error());
            manifest_.pictures[picture] = std::move(*record);
            ++summary_.own_images;
        }
    return {};
}

Expected<void> Run::save_manifest() const {
    auto manifest = manifest_;
    manifest.program = PAIRLIGHT_PROGRAM_VERSION;
    manifest.study_sha256 = loaded_.sha256;
    return write_text_file(loaded_.folder.manifest(), manifest_json(manifest));
}

void Run::report(const std::string& what, double of_this_scene) const {
    const auto wanted_scenes = std::ranges::count_if(
        study().scenes, [&](const Scene& scene) { return wanted(scene, options_); });
    progress_(what, (static_cast<double>(scenes_done_) + of_this_scene) /
                        static_cast<double>(wanted_scenes));
}

} // namespace

Expected<RenderSummary> render_study(const LoadedStudy& loaded,
                                     const RenderOptions& options,
                                     const RenderProgress& progress) {
    return Run(loaded, options, progress).carry_out();
}

Expected<Manifest> read_manifest(const StudyFolder& folder) {
    if (!fs::exists(folder.manifest()))
        return Manifest{};
    const auto text = read_text_file(folder.manifest());
    if (!text)
        return tl::unexpected(text.error());
    return parse_manifest(*text, folder.manifest().string());
}

} // namespace experiment::stimuli
