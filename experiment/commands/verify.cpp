// pairlight verify: whether the record of votes is whole.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/read_study.h"
#include "experiment/store/sqlite_store.h"

#include <fmt/core.h>

#include <memory>

namespace experiment::commands {

void add_verify(Command& program) {
    struct Options {
        std::string study;
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto command =
        program.add_command("verify", "Whether the record of votes is whole and unchanged");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    add_voice(command, options->voice);
    command.runs([options] {
        const auto file = study_folder(options->study).votes();
        const auto store = value_or_stop(store::open_votes(file));
        const auto faults = value_or_stop(store->verify());
        for (const auto& fault : faults)
            fmt::print("{}\n", fault);
        if (!faults.empty())
            throw CommandError(fmt::format("{}: the record is not whole: {} faults", file.string(),
                                           faults.size()));
        fmt::print("{}: whole; {} sittings, {} votes\n", file.string(),
                   value_or_stop(store->sittings()).size(), value_or_stop(store->votes()).size());
    });
}

} // namespace experiment::commands
