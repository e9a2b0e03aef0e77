// The pictures of a sitting.
#include "experiment/commands/stimulus_files.h"

#include "experiment/stimuli/display_picture.h"
#include "experiment/stimuli/scene_renderer.h"
#include "experiment/text_files.h"
#include "protocols/digest.h"

#include <fmt/format.h>

namespace experiment::commands {

namespace {

tl::expected<std::string, std::string> digest_of_file(const LoadedStudy& loaded,
                                                      const protocols::Picture& picture) {
    return read_text_file(stimuli::png_file(loaded.folder, picture))
        .map([](const std::string& bytes) { return protocols::sha256_hexadecimal(bytes); });
}

} // namespace

tl::expected<StimulusDigests, std::string> stimulus_digests(const LoadedStudy& loaded) {
    StimulusDigests digests;
    for (const auto& scene : loaded.study.scenes)
        for (const auto& variant : shown_variants(loaded.study))
            for (const auto& condition : loaded.study.conditions) {
                const protocols::Picture picture{scene.id, variant.id, condition.id};
                auto digest = digest_of_file(loaded, picture);
                if (!digest)
                    return tl::unexpected(digest.error());
                digests[picture] = std::move(*digest);
            }
    return digests;
}

std::string digest_of(const StimulusDigests& digests) {
    std::string text;
    for (const auto& [picture, digest] : digests)
        text += fmt::format("{} {}\n", picture_path(picture), digest);
    return protocols::sha256_hexadecimal(text);
}

session::LoadPicture load_unchanged(const LoadedStudy& loaded, StimulusDigests digests) {
    return [&loaded, digests = std::move(digests)](const protocols::Picture& picture)
               -> tl::expected<renderer::gpu::Picture8, std::string> {
        const auto digest = digest_of_file(loaded, picture);
        if (!digest)
            return tl::unexpected(digest.error());
        if (*digest != digests.at(picture))
            return tl::unexpected(fmt::format(
                "{}: was changed while the sitting took place; its votes so far stand, expected "
                "the file with SHA-256 {}",
                stimuli::png_file(loaded.folder, picture).string(), digests.at(picture)));
        return stimuli::picture_for_display(loaded, picture);
    };
}

} // namespace experiment::commands
