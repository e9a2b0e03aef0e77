// A recipe is made again from the study and from what the manifest says of model and renderer.
#include "experiment/stimuli/freshness.h"

#include "experiment/stimuli/own_images.h"
#include "experiment/stimuli/recipe.h"
#include "experiment/stimuli/render_study.h"
#include "experiment/stimuli/scene_renderer.h"
#include "experiment/text_files.h"
#include "protocols/digest.h"
#include "renderer/expected.h"

#include <fmt/core.h>

namespace experiment::stimuli {

using protocols::Picture;
using renderer::Expected;

namespace {

Expected<void> check_rendered(const LoadedStudy& loaded,
                              const Manifest& manifest,
                              const protocols::Scene& scene,
                              const protocols::Variant& variant,
                              const Picture& picture) {
    const auto file = png_file(loaded.folder, picture);
    const auto refuse = [&](const char* what) {
        return tl::unexpected(fmt::format("{}: {}; `pairlight render {}` makes the stimuli",
                                          file.string(), what, loaded.folder.root.string()));
    };
    const auto found = manifest.pictures.find(picture);
    if (found == manifest.pictures.end() || !std::filesystem::exists(file))
        return refuse("is missing");
    const auto& record = found->second;
    const auto model = record.model.value_or(ModelRecord{});
    if (record.recipe != recipe(loaded.study, scene, variant, model,
                                renderer_of_run(record.renderer), RenderOptions{}.samples))
        return refuse("was rendered before the study was changed");
    const auto bytes = read_text_file(file);
    if (!bytes)
        return tl::unexpected(bytes.error());
    if (protocols::sha256_hexadecimal(*bytes) != record.png_sha256)
        return refuse("is not the file that was rendered");
    return {};
}

} // namespace

Expected<void> check_stimuli(const LoadedStudy& loaded) {
    const auto manifest = read_manifest(loaded.folder);
    if (!manifest)
        return tl::unexpected(manifest.error());
    for (const auto& scene : loaded.study.scenes)
        for (const auto& variant : shown_variants(loaded.study))
            for (const auto& condition : loaded.study.conditions) {
                const Picture picture{scene.id, variant.id, condition.id};
                const auto checked =
                    std::holds_alternative<protocols::OwnImages>(condition.source)
                        ? inspect_own_image(loaded, picture).map([](const PictureRecord&) {})
                        : check_rendered(loaded, *manifest, scene, variant, picture);
                if (!checked)
                    return checked;
            }
    return {};
}

} // namespace experiment::stimuli
