// pairlight schedule: the trials a sitting would have, as a table.
#include "protocols/schedule.h"

#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/sittings.h"
#include "experiment/read_study.h"
#include "experiment/tables.h"

#include <fmt/core.h>

#include <memory>

namespace experiment::commands {

void add_schedule(Command& program) {
    struct Options {
        std::string study;
        std::string observer;
        int session = 1;
        std::string csv;
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto command = program.add_command("schedule", "The trials a sitting would have, as CSV");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    command.add_option("--observer", options->observer, "The observer's pseudonym").required();
    command.add_option("--session", options->session, "Which sitting, from 1").shows_default();
    command.add_option("--csv", options->csv,
                       "The file to write; without it, or with -, standard output");
    add_voice(command, options->voice);
    command.runs([options] {
        const auto loaded = value_or_stop(read_study(options->study));
        const auto schedule = value_or_stop(protocols::make_schedule(
            loaded.study, {options->observer}, options->session,
            partner_of(loaded, {options->observer}, store::ObserverKind::Person)));
        deliver(schedule_csv(schedule), options->csv, files_of(loaded));
        options->voice.remark(fmt::format("Order: {}; generator {}, seed {}.", schedule.scene_rule,
                                          schedule.generator, schedule.order_seed));
    });
}

} // namespace experiment::commands
