// pairlight simulate: a whole experiment by simulated observers, through the same session code.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/sittings.h"

#include <fmt/core.h>

#include <memory>

namespace experiment::commands {

void add_simulate(Command& program) {
    struct Options {
        std::string study;
        int observers = 10;
        std::string specification;
        std::string window;
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "simulate",
        "A whole experiment by simulated observers; their votes are marked as such everywhere");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    command.add_option("--observers", options->observers, "How many").within(1, 999).required();
    command.add_option(
        "--observer-spec", options->specification,
        "True scores, noise, bias, lapses and seed, such as \"scores=a:1,b:0;noise=1;seed=7\"");
    command.add_option("--window", options->window,
                       "Through a real window of this size, such as 1280x800, at full speed");
    add_voice(command, options->voice);
    command.runs([options] {
        const auto loaded = value_or_stop(read_study(options->study));
        simulate_observers(loaded, options->observers, options->specification, options->voice,
                           window_size(options->window));
        const auto sittings = loaded.study.plan.sessions;
        fmt::print("{}: {} simulated {} finished {} each\n", loaded.folder.votes().string(),
                   options->observers, options->observers == 1 ? "observer has" : "observers have",
                   sittings == 1 ? "one sitting" : fmt::format("{} sittings", sittings));
    });
}

} // namespace experiment::commands
