// pairlight compare: how far one picture is from another, in every measure people use.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/errors_json.h"
#include "experiment/stimuli/reference_file.h"
#include "renderer/imaging/brightness.h"
#include "renderer/imaging/errors.h"
#include "renderer/imaging/image_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace experiment::commands {

namespace fs = std::filesystem;
namespace imaging = renderer::imaging;

namespace {

struct Options {
    std::string picture, reference, mask, json, maps;
    double pixels_per_degree = imaging::default_pixels_per_degree;
    Voice voice;
};

/// Linear EXR as it is; PNG, JPEG and TIFF decoded by the sRGB curve.
imaging::LinearImage read_light(const std::string& file) {
    if (fs::path(file).extension() == ".exr")
        return value_or_stop(imaging::read_exr(file));
    const auto picture = value_or_stop(imaging::read_encoded(file));
    const auto& image = picture.image;
    const auto pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    imaging::LinearImage light{image.width, image.height, {}, std::vector<float>(pixels, 1.0F)};
    for (std::size_t i = 0; i < pixels; ++i)
        light.pixels.push_back(imaging::light_at(image, i));
    return light;
}

/// Pixels the mask's picture covers, where it has coverage, or shows as more than half grey.
std::vector<std::size_t> read_mask(const std::string& file) {
    if (fs::path(file).extension() == ".exr")
        return imaging::covered_pixels(value_or_stop(imaging::read_exr(file)).coverage);
    const auto image = value_or_stop(imaging::read_encoded(file)).image;
    std::vector<std::size_t> mask;
    for (std::size_t i = 0; 3 * i < image.codes.size(); ++i)
        if (2 * image.codes[3 * i + 1] >= 1 << image.bits)
            mask.push_back(i);
    return mask;
}

/// What the reference's noise alone makes of the measures; nothing when it keeps no halves.
std::optional<imaging::ImageErrors> noise_floor(const std::string& file,
                                                const std::vector<std::size_t>& mask,
                                                const imaging::ErrorSettings& settings) {
    if (fs::path(file).extension() != ".exr")
        return std::nullopt;
    const auto stored = stimuli::read_reference(file);
    if (!stored)
        return std::nullopt;
    const auto [even, odd] = renderer::reference::halves(stored->film);
    return value_or_stop(imaging::image_errors(even, odd, mask, settings));
}

struct Maps {
    fs::path flip, structure, relative;
};

Maps maps_of(const Options& options) {
    return {options.maps + "-flip.png", options.maps + "-ssim.png", options.maps + "-relative.png"};
}

/// Neither a picture that was compared nor, to the measures, one of the maps that are to be made.
void expect_nothing_lost(const Options& options) {
    Inputs kept{options.picture, options.reference, options.mask};
    if (!options.maps.empty()) {
        const auto [flip, structure, relative] = maps_of(options);
        for (const auto& map : {flip, structure, relative})
            expect_not_lost(map, kept);
        kept.insert(kept.end(), {flip, structure, relative});
    }
    if (!is_standard_output(options.json))
        expect_not_lost(options.json, kept);
}

void write_map(const imaging::Plane& values, double low, double high, const fs::path& file) {
    value_or_stop(
        imaging::write_png(file, imaging::encode_16bit(imaging::error_map(values, low, high))));
}

/// FLIP, structure, and the relative difference of light, each as a picture.
void write_maps(const Options& options,
                const imaging::LinearImage& picture,
                const imaging::LinearImage& reference) {
    const auto maps = maps_of(options);
    write_map(imaging::ldr_flip(picture, reference, options.pixels_per_degree), 0, 1, maps.flip);
    auto structure = imaging::ssim_map(picture, reference);
    for (auto& value : structure.values)
        value = 1 - value;
    write_map(structure, 0, 1, maps.structure);
    imaging::Plane relative(picture.width, picture.height);
    for (std::size_t i = 0; i < relative.values.size(); ++i) {
        const auto &x = picture.pixels[i], &y = reference.pixels[i];
        const auto square = [](float a, float b) {
            const auto d = static_cast<double>(a) - static_cast<double>(b);
            return d * d / (static_cast<double>(b) * static_cast<double>(b) + 0.01);
        };
        relative.values[i] = static_cast<float>(
            std::sqrt((square(x.r, y.r) + square(x.g, y.g) + square(x.b, y.b)) / 3));
    }
    write_map(relative, 0, 1, maps.relative);
}

void run(const Options& options) {
    const auto picture = read_light(options.picture);
    const auto reference = read_light(options.reference);
    const auto mask = options.mask.empty() ? imaging::covered_pixels(reference.coverage)
                                           : read_mask(options.mask);
    if (!mask.empty() && mask.back() >= std::min(picture.pixels.size(), reference.pixels.size()))
        throw CommandError(fmt::format("{}: the mask has more pixels than the pictures, expected "
                                       "one size",
                                       options.mask));
    imaging::ErrorSettings settings{options.pixels_per_degree, imaging::Brightness::Raw};
    Comparison comparison{.pixels = mask.size(), .pixels_per_degree = options.pixels_per_degree};
    comparison.raw = value_or_stop(imaging::image_errors(picture, reference, mask, settings));
    comparison.gain = value_or_stop(imaging::brightness_gain(picture, reference, mask));
    comparison.noise_floor = noise_floor(options.reference, mask, settings);
    settings.brightness = imaging::Brightness::Equalised;
    comparison.equalised = value_or_stop(imaging::image_errors(picture, reference, mask, settings));
    expect_nothing_lost(options);
    if (!options.maps.empty())
        write_maps(options, picture, reference);
    if (!options.json.empty())
        deliver(errors_json(comparison), options.json, {});
    if (options.voice.says_text_beside(options.json))
        fmt::print("{}", errors_text(comparison));
}

} // namespace

void add_compare(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "compare", "How far a picture is from a reference: RMSE, MAE, relMSE, PSNR, SSIM, FLIP");
    command.add_option("A", options->picture, "The picture: linear EXR, or PNG, JPEG, TIFF")
        .required();
    command.add_option("B", options->reference, "What it should look like").required();
    command.add_option("--mask", options->mask,
                       "Pixels that count: an EXR's coverage, or a picture's light parts; without "
                       "it, what B covers");
    command.add_option("--json", options->json,
                       "Write the measures here, all digits; - is standard output");
    command
        .add_option("--maps", options->maps,
                    "Write pictures of the errors: <MAPS>-flip.png, -ssim.png, -relative.png")
        .not_standard_output();
    command
        .add_option("--pixels-per-degree", options->pixels_per_degree,
                    "Of the observer's visual angle, for FLIP")
        .within(1.0, 1000.0)
        .shows_default();
    add_voice(command, options->voice);
    command.runs([options] { run(*options); });
}

} // namespace experiment::commands
