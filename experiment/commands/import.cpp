// pairlight import: a folder of pictures made elsewhere becomes a study's stimuli.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/tone_curve.h"
#include "experiment/read_study.h"
#include "experiment/stimuli/own_images.h"
#include "experiment/stimuli/scene_renderer.h"
#include "experiment/text_files.h"
#include "protocols/digest.h"
#include "renderer/imaging/image_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace experiment::commands {

namespace {

namespace fs = std::filesystem;
namespace imaging = renderer::imaging;

struct Options {
    std::string study;
    std::string from;
    std::string curve;
    double exposure = 0;
    std::string colour = "refuse";
    Voice voice;
};

/// The file of a picture below `folder`, whatever its kind.
fs::path source_of(const fs::path& folder, const protocols::Picture& picture) {
    std::vector<fs::path> found;
    for (const auto* ending : {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr"})
        if (auto file = folder / (picture_path(picture) + ending); fs::exists(file))
            found.push_back(std::move(file));
    if (found.empty())
        throw CommandError(fmt::format("{}: is missing; expected one of .png, .jpg, .jpeg, .tif, "
                                       ".tiff, .exr there",
                                       (folder / picture_path(picture)).string()));
    if (found.size() > 1)
        throw CommandError(fmt::format("{} and {}: both could be the picture; expected one",
                                       found[0].string(), found[1].string()));
    return found.front();
}

struct Imported {
    imaging::EncodedImage image;
    std::string how; ///< in words, for the record
};

Imported from_light(const fs::path& file, const Options& options) {
    if (options.curve.empty())
        throw CommandError(fmt::format("{}: is linear light; expected --curve clip or --curve "
                                       "reinhard, which says how a display shows it",
                                       file.string()));
    const auto light = value_or_stop(imaging::read_exr(file));
    if (std::any_of(light.coverage.begin(), light.coverage.end(),
                    [](float covered) { return !(covered >= 1); }))
        throw CommandError(
            fmt::format("{}: is transparent in places, expected an opaque picture", file.string()));
    const ToneCurve curve{options.curve == "reinhard" ? ToneCurve::Kind::Reinhard
                                                      : ToneCurve::Kind::Clip,
                          options.exposure};
    const auto mapped = tone_mapped(light, curve);
    return {imaging::encode_16bit(mapped.image),
            fmt::format("{}, {:.4f} % of pixels cut", text_of(curve), 100 * mapped.clipped)};
}

Imported from_codes(const fs::path& file, const Options& options) {
    auto read = value_or_stop(imaging::read_encoded(file));
    if (read.colour_remark.empty())
        return {std::move(read.image), "codes as they are, sRGB"};
    if (options.colour != "as-is")
        throw CommandError(fmt::format("{}: has {}, expected sRGB; convert it, or show its codes "
                                       "as if they were with --colour as-is",
                                       file.string(), read.colour_remark));
    return {std::move(read.image), "codes as they are, in spite of " + read.colour_remark};
}

void run(const Options& options) {
    const auto loaded = value_or_stop(read_study(options.study));
    std::vector<std::pair<protocols::Picture, Imported>> pictures;
    Inputs sources;
    std::string record = "picture\tsource\tsource_sha256\thow\n";
    for (const auto& scene : loaded.study.scenes)
        for (const auto& variant : shown_variants(loaded.study))
            for (const auto& condition : loaded.study.conditions) {
                if (!std::holds_alternative<protocols::OwnImages>(condition.source))
                    continue;
                const protocols::Picture picture{scene.id, variant.id, condition.id};
                const auto file = source_of(options.from, picture);
                sources.push_back(file);
                value_or_stop(stimuli::expect_size(loaded, picture, file));
                auto imported = file.extension() == ".exr" ? from_light(file, options)
                                                           : from_codes(file, options);
                record +=
                    fmt::format("{}\t{}\t{}\t{}\n", picture_path(picture), file.filename().string(),
                                protocols::sha256_hexadecimal(value_or_stop(read_text_file(file))),
                                imported.how);
                pictures.emplace_back(picture, std::move(imported));
            }
    for (const auto& [picture, imported] : pictures)
        expect_not_lost(stimuli::png_file(loaded.folder, picture), sources);
    // Only now that all of them can be taken is anything written.
    for (const auto& [picture, imported] : pictures) {
        const auto file = stimuli::png_file(loaded.folder, picture);
        std::error_code failed; // writing says what is wrong with the folder
        fs::create_directories(file.parent_path(), failed);
        value_or_stop(
            imaging::write_png(file, imported.image, {{"pairlight:import", imported.how}}));
    }
    value_or_stop(write_text_file(loaded.folder.stimuli() / "imported.tsv", record));
    fmt::print("{}: {} pictures\n", (loaded.folder.stimuli() / "imported.tsv").string(),
               pictures.size());
}

} // namespace

void add_import(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "import", "Take a study's own images from a folder: PNG, JPEG, TIFF or EXR");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    command
        .add_option("--from", options->from,
                    "The folder: <scene>/[<variant>/]<condition>.png, .jpg, .tif or .exr")
        .required()
        .existing_folder();
    command.add_option("--curve", options->curve, "How light becomes what a display shows (EXR)")
        .one_of({"clip", "reinhard"});
    command
        .add_option("--exposure", options->exposure, "Stops by which light is lifted first (EXR)")
        .within(-20.0, 20.0)
        .shows_default();
    command
        .add_option("--colour", options->colour,
                    "Pictures with another colour profile than sRGB: refuse them, or take their "
                    "codes as-is")
        .one_of({"refuse", "as-is"});
    add_voice(command, options->voice);
    command.runs([options] { run(*options); });
}

} // namespace experiment::commands
