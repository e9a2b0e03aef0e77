// pairlight view: a study or a model in real time, under the hand.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/progress.h"
#include "experiment/viewer/exhibit.h"
#include "experiment/viewer/keys.h"
#include "experiment/viewer/off_screen.h"
#include "experiment/viewer/viewer.h"
#include "experiment/viewer/viewer_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace experiment::commands {

namespace {

struct Options {
    std::string name;
    viewer::ModelOptions model;
    std::array<int, 2> size{1280, 800};
    std::vector<std::string> strokes;
    std::string screenshot;
    int frames = 0;
    Voice voice;
};

void check_strokes(const std::vector<std::string>& strokes) {
    for (const auto& stroke : strokes)
        if (!viewer::input_of(stroke))
            throw CommandError(fmt::format(
                "--press {}: there is no such key; expected names such as T, Shift+Left, + or Esc, "
                "as the viewer's help (H) has them",
                stroke));
}

void check_screenshot(const std::string& file) {
    if (!file.empty() && std::filesystem::path(file).extension() != ".png")
        throw CommandError(fmt::format("--screenshot {}: expected a name that ends in .png", file));
}

std::unique_ptr<viewer::Display> display_for(const Options& options, const std::string& title) {
    const auto [width, height] = options.size;
    if (!options.screenshot.empty())
        return value_or_stop(viewer::OffScreen::create(width, height));
    return value_or_stop(viewer::open_viewer_window(width, height, title));
}

void view(const Options& options) {
    check_strokes(options.strokes);
    check_screenshot(options.screenshot);
    const auto exhibit = value_or_stop(viewer::open_exhibit(options.name, options.model));
    const auto display = display_for(options, "Pairlight: " + exhibit.name);
    viewer::ViewerOptions how{.strokes = options.strokes};
    ProgressBar bar("tracing", !options.voice.quiet);
    if (!options.screenshot.empty()) {
        how.screenshot = options.screenshot;
        how.progress = [&](double fraction) { bar.update(fraction); };
    }
    if (options.frames > 0 || how.screenshot)
        how.frames = std::max(options.frames, 3); // controls settle by the third
    value_or_stop(viewer::run_viewer(exhibit, *display, how));
}

} // namespace

void add_view(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "view", "A study or a model in real time: walk round it, move the light, compare methods");
    command
        .add_option("STUDY|MODEL", options->name,
                    "Study folder or its study.toml; or a model file, a model's name, or a body")
        .required();
    command.add_option("--material", options->model.material, "What a model is made of")
        .shows_default();
    command
        .add_option("--diameter", options->model.diameter_mm,
                    "How large a model is made: diameter of its bounding sphere, mm")
        .within(1e-6, 1e9)
        .shows_default();
    command.add_option("--size", options->size, "Width and height of the window, pixels")
        .within(1, 16384)
        .shows_default();
    command.add_option("--press", options->strokes,
                       "Keys pressed at the start, such as S T Shift+Left");
    command
        .add_option("--screenshot", options->screenshot,
                    "Draw without a display, write this PNG and the light as EXR, and end")
        .shown_as("FILE.png");
    command
        .add_option("--frames", options->frames,
                    "End after so many pictures that follow the keys, at least 3")
        .within(1, 1e9);
    add_voice(command, options->voice);
    command.runs([options] { view(*options); });
}

} // namespace experiment::commands
