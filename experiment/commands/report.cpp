// pairlight report: the findings on one page, with figures.
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/steps.h"

#include <fmt/core.h>

#include <memory>

namespace experiment::commands {

void add_report(Command& program) {
    struct Options {
        std::string study;
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto command =
        program.add_command("report", "The findings on one HTML page, with figures as SVG and PDF");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    add_voice(command, options->voice);
    command.runs([options] {
        fmt::print(
            "{}\n",
            write_study_report(value_or_stop(read_study(options->study)), options->voice).string());
    });
}

} // namespace experiment::commands
