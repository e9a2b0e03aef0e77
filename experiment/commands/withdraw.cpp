// pairlight withdraw: everything of an observer is removed, at their wish.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/sittings.h"
#include "experiment/session/clock.h"
#include "experiment/vote_source.h"

#include <fmt/core.h>

#include <memory>

namespace experiment::commands {

void add_withdraw(Command& program) {
    struct Options {
        std::string study;
        std::string observer;
        std::string reason;
        bool sure = false;
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "withdraw", "Remove everything of an observer, at their wish; a tombstone stays");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    command.add_option("--observer", options->observer, "The observer's pseudonym").required();
    command.add_option("--reason", options->reason, "Why, without personal data; it is recorded")
        .not_blank("a reason in words; it is recorded")
        .required();
    command.add_flag("--for-good", options->sure, "Yes: it cannot be undone");
    add_voice(command, options->voice);
    command.runs([options] {
        const auto loaded = value_or_stop(read_study(options->study));
        if (!options->sure)
            throw CommandError(fmt::format("everything of observer {} would be removed for good; "
                                           "expected --for-good if that is wanted",
                                           options->observer));
        value_or_stop(open_whole_votes(loaded.folder)); // nothing is removed from a broken record
        const auto store = writable_store(loaded);
        const auto tombstone = value_or_stop(
            store->withdraw({options->observer}, session::utc_text(session::SystemClock().wall()),
                            options->reason));
        fmt::print("withdrawn: {} rows, {} votes of them\n", tombstone.rows, tombstone.votes);
        options->voice.remark("Reports, exports and copies that were made before still hold these "
                              "votes; make them again.");
    });
}

} // namespace experiment::commands
