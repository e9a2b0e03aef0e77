// pairlight report: the findings on one page, with figures.
#include "experiment/commands/commands.h"
#include "experiment/commands/steps.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <memory>

namespace experiment::commands {

void add_report(CLI::App& program) {
    struct Options {
        std::string study;
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto* command = program.add_subcommand(
        "report", "The findings on one HTML page, with figures as SVG and PDF");
    command->add_option("STUDY", options->study, "Study folder or its study.toml")->required();
    add_voice(*command, options->voice);
    command->callback([options] {
        fmt::print(
            "{}\n",
            write_study_report(value_or_stop(read_study(options->study)), options->voice).string());
    });
}

} // namespace experiment::commands
