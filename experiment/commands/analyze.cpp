// pairlight analyze: what the votes mean, as text for a person and as JSON for a program.
#include "analysis/findings_json.h"
#include "analysis/findings_text.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/steps.h"
#include "experiment/text_files.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <memory>

namespace experiment::commands {

void add_analyze(CLI::App& program) {
    struct Options {
        std::string source;
        std::string json;
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto* command = program.add_subcommand(
        "analyze", "Ranking, analyses of variance and comparisons of the votes");
    command->add_option("STUDY|VOTES.csv", options->source, "A study, or a table of votes")
        ->required();
    command->add_option("--json", options->json, "Write the findings here, all digits");
    add_voice(*command, options->voice);
    command->callback([options] {
        const auto findings = findings_of(value_or_stop(read_votes(options->source)));
        if (!options->json.empty())
            value_or_stop(write_text_file(options->json, analysis::findings_json(findings)));
        if (!options->voice.quiet)
            fmt::print("{}", analysis::findings_text(findings));
    });
}

} // namespace experiment::commands
