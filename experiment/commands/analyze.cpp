// pairlight analyze: what the votes mean, as text for a person and as JSON for a program.
#include "analysis/findings_json.h"
#include "analysis/findings_text.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/steps.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <memory>
#include <utility>
#include <vector>

namespace experiment::commands {

void add_analyze(CLI::App& program) {
    struct Options {
        std::string source;
        std::string json;
        std::vector<std::string> order;
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto* command = program.add_subcommand(
        "analyze", "Ranking, analyses of variance and comparisons of the votes");
    command->add_option("STUDY|VOTES.csv", options->source, "A study, or a table of votes")
        ->required();
    command->add_option("--json", options->json, "Write the findings here, all digits");
    command
        ->add_option("--order", options->order,
                     "Conditions in the order tables and pairs follow, such as a,b,c; a study has "
                     "its own, and a "
                     "table that of appearance")
        ->delimiter(',');
    add_voice(*command, options->voice);
    command->callback([options] {
        auto votes = value_or_stop(read_votes(options->source));
        if (!options->order.empty())
            votes.table = value_or_stop(
                analysis::with_condition_order(std::move(votes.table), options->order));
        const auto findings = findings_of(votes);
        if (!options->json.empty())
            deliver(analysis::findings_json(findings), options->json, options->source);
        if (!options->voice.quiet || options->json.empty())
            fmt::print("{}", analysis::findings_text(findings));
    });
}

} // namespace experiment::commands
