// pairlight session: one sitting of one observer.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/sittings.h"

#include <fmt/core.h>

#include <memory>

namespace experiment::commands {

namespace {

struct Options {
    std::string study;
    std::string observer;
    int session = 0;
    std::optional<std::string> simulate;
    SeatOptions seat;
    std::string window;
    Voice voice;
};

void run(Options options) {
    options.seat.size = window_size(options.window);
    const auto loaded = value_or_stop(read_study(options.study));
    const protocols::ObserverId observer{options.observer};
    const int session = options.session > 0 ? options.session : next_session(loaded, observer);
    const auto outcome = options.simulate
                             ? simulate_sitting(loaded, observer, session, *options.simulate, 0)
                             : sit(loaded, observer, session, options.seat, options.voice);
    fmt::print("{}{}: sitting {}, {} votes, {}\n", options.simulate ? "SIMULATED " : "",
               options.observer, session, outcome.votes,
               outcome.finished ? "finished" : "not finished");
}

} // namespace

void add_session(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command =
        program.add_command("session", "One sitting of one observer; an unfinished one goes on");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    command.add_option("--observer", options->observer, "The observer's pseudonym, never a name")
        .required();
    command.add_option("--session", options->session, "Which sitting; without it, the next one")
        .within(1, 1000);
    command
        .add_option(
            "--simulate", options->simulate,
            "Vote by a simulated observer, such as \"scores=a:1,b:0;noise=1;seed=7\"; no window")
        .may_be_empty();
    command.add_option("--window", options->window,
                       "A window of this size, such as 1280x720, not the full screen");
    command.add_option("--monitor", options->seat.monitor, "Which monitor; 1 is the primary one")
        .within(1, 1000);
    command
        .add_option("--override-days", options->seat.override_reason,
                    "Sit earlier than the study allows, for this reason; it is recorded")
        .not_blank("a reason in words; it is recorded");
    command.add_flag("--set-up", options->seat.setting_up,
                     "Begin with the experimenter's pages: the display, brightness and contrast");
    command.add_flag("--allow-long", options->seat.allow_long,
                     "Sit even if the plan takes longer than the study allows");
    add_voice(command, options->voice);
    command.runs([options] { run(*options); });
}

} // namespace experiment::commands
