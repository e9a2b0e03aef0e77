// pairlight demo: the quick study from an empty folder to a finished report.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/sittings.h"
#include "experiment/commands/steps.h"
#include "experiment/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>

namespace experiment::commands {

namespace {

/// True scores of the demo's simulated observers, in units of their noise: an invention, and marked
/// as one on every page and in every figure.
constexpr const char* invented_scores =
    "scores=shss-25:0.9,shss-4:0.5,green:-0.4,phong:-1.0;noise=1;seed=2012";

constexpr int simulated_observers = 10;

bool has_display() {
    const auto is_set = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

bool wants_to_sit() {
    if (!has_display() || isatty(STDIN_FILENO) == 0)
        return false;
    fmt::print(stderr, "Will you sit the study yourself first? Two to three minutes, if you do not "
                       "linger. [Y/n] ");
    std::string answer;
    std::getline(std::cin, answer);
    return std::cin && (answer.empty() || answer.front() == 'y' || answer.front() == 'Y');
}

/// Where no window can be had, the demo goes on without.
void try_to_sit(const LoadedStudy& loaded, const Voice& voice) {
    try {
        sit(loaded, {"you"}, 1, {}, voice);
    } catch (const CommandError& error) {
        voice.remark(fmt::format("no sitting of yours: {}", error.what()));
    }
}

void run_demo(const std::string& folder, const Voice& voice) {
    const auto start = std::chrono::steady_clock::now();
    if (std::filesystem::exists(StudyFolder{folder}.votes()))
        throw CommandError(fmt::format(
            "{}: holds votes already, and the demo leaves votes alone; name another folder",
            StudyFolder{folder}.votes().string()));
    if (!std::filesystem::exists(StudyFolder{folder}.study_file()))
        make_study_folder(folder, "quick");
    const auto loaded = value_or_stop(read_study(folder));
    voice.remark(
        fmt::format("1/4 the study: {} (conditions, scenes and lights are in it to be changed)",
                    loaded.folder.study_file().string()));

    const auto summary = render_stimuli(loaded, {}, voice);
    voice.remark(fmt::format("2/4 the stimuli: {} rendered, {} up to date", summary.rendered,
                             summary.up_to_date));

    if (wants_to_sit())
        try_to_sit(loaded, voice);
    simulate_observers(loaded, simulated_observers, invented_scores, voice);
    voice.remark(fmt::format("3/4 the votes: {} simulated observers have finished the study",
                             simulated_observers));

    const auto report = write_study_report(loaded, voice);
    voice.remark(fmt::format("4/4 the report, {} after the start",
                             spoken_duration(std::chrono::duration_cast<std::chrono::seconds>(
                                 std::chrono::steady_clock::now() - start))));
    fmt::print("{}\n", std::filesystem::absolute(report).lexically_normal().string());
}

} // namespace

void add_demo(Command& program) {
    struct Options {
        std::string folder = "demo-study";
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto command =
        program.add_command("demo", "The quick study from an empty folder to a finished report");
    command.add_option("DIR", options->folder, "The study folder to make")
        .not_standard_output()
        .shows_default();
    add_voice(command, options->voice);
    command.runs([options] { run_demo(options->folder, options->voice); });
}

} // namespace experiment::commands
