// pairlight analyze: what the votes mean, as text for a person and as JSON for a program.
#include "analysis/csv.h"
#include "analysis/findings_json.h"
#include "analysis/findings_text.h"
#include "analysis/utf8.h"
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/commands/steps.h"
#include "experiment/read_study.h"
#include "experiment/store/screened.h"
#include "experiment/text_files.h"

#include <fmt/core.h>

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace experiment::commands {

namespace {

using analysis::formats::VoteFormat;

struct Options {
    std::string source;
    std::string json;
    std::vector<std::string> order;
    VoteFormat format = VoteFormat::Detect;
    bool repeats = false;
    std::string groups;
    analysis::AnalysisOptions analysis;
    Voice voice;
};

const std::map<std::string, VoteFormat>& formats() {
    static const std::map<std::string, VoteFormat> names{
        {"detect", VoteFormat::Detect},
        {"long", VoteFormat::Long},
        {"pairs", VoteFormat::Pairs},
        {"matrix", VoteFormat::Matrix},
        {"observer-matrices", VoteFormat::ObserverMatrices},
        {"wide", VoteFormat::Wide},
        {"paired-comparison", VoteFormat::PairedComparison},
        {"sureal", VoteFormat::Sureal}};
    return names;
}

// A table `observer,<name>`: who belongs to which group.
void read_groups(const std::string& path, analysis::AnalysisOptions& options) {
    const auto text = value_or_stop(read_text_file(path));
    if (const auto fault = analysis::utf8_fault(text, path); !fault.empty())
        throw CommandError(fault);
    value_or_stop(analysis::read_csv(
        text, path, [&](std::int64_t, std::span<const std::string_view> fields) -> std::string {
            if (fields.size() != 2)
                return fmt::format("{} fields, expected two: observer and group", fields.size());
            if (options.group_name.empty()) {
                options.group_name = fields[1];
                return fields[0] == "observer" && !fields[1].empty()
                           ? ""
                           : "expected a header row: observer, and what the groups are called";
            }
            if (!options.groups.emplace(fields[0], fields[1]).second)
                return fmt::format("observer '{}' stands twice", fields[0]);
            return fields[1].empty() ? "an empty group, expected a name" : "";
        }));
    if (options.groups.empty())
        throw CommandError(fmt::format(
            "{}: there is no observer in it, expected a row observer,group for each", path));
}

void check_groups(const analysis::VoteTable& table, const Options& options) {
    for (const auto& observer : table.observers.names())
        if (!options.groups.empty() && !options.analysis.groups.contains(observer))
            throw CommandError(
                fmt::format("{}: observer '{}' has no group", options.groups, observer));
}

/// Of a table made elsewhere, all observers count: it does not say who was screened.
std::string informal_line(const VoteSource& votes) {
    auto observers = votes.table.observers.names().size();
    if (votes.study) {
        const auto store = value_or_stop(open_whole_votes(votes.study->folder));
        observers = value_or_stop(store::screened_observers(*store)).size();
    }
    return observers < store::formal_observers
               ? fmt::format("\nAn informal study (fewer than {} observers{}), by ITU-R BT.500.\n",
                             store::formal_observers, votes.study ? " passed a screening" : "")
               : "";
}

Inputs inputs_of(const Options& options, const VoteSource& votes) {
    auto files = votes.study ? files_of(*votes.study) : Inputs{};
    files.insert(files.end(), {options.source, options.groups});
    return files;
}

void run(Options& options) {
    auto votes = value_or_stop(
        read_votes(options.source, options.format,
                   options.repeats ? analysis::Repeats::Allow : analysis::Repeats::Refuse));
    if (!options.order.empty())
        votes.table =
            value_or_stop(analysis::with_condition_order(std::move(votes.table), options.order));
    if (!options.groups.empty())
        read_groups(options.groups, options.analysis);
    check_groups(votes.table, options);
    const auto findings = findings_of(votes, options.analysis);
    if (!options.json.empty())
        deliver(analysis::findings_json(findings), options.json, inputs_of(options, votes));
    if (options.voice.says_text_beside(options.json))
        fmt::print("{}{}", analysis::findings_text(findings), informal_line(votes));
}

} // namespace

void add_analyze(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "analyze", "Ranking, analyses of variance, scales and consistency of the votes");
    command.add_option("STUDY|VOTES.csv", options->source, "A study, or a table of votes")
        .required();
    command.add_option("--json", options->json,
                       "Write the findings here, all digits; - is standard output");
    command
        .add_option("--order", options->order,
                    "Conditions in the order tables and pairs follow, such as a,b,c; a study has "
                    "its own, and a table that of appearance")
        .separated_by(',');
    command.add_choice("--format", options->format, "What the table is, where it does not show",
                       formats());
    command.add_flag("--repeats", options->repeats,
                     "The same question may have been answered more than once in a session");
    command.add_option("--groups", options->groups,
                       "A table observer,NAME that puts observers into groups (mixed analysis)");
    command
        .add_option("--level", options->analysis.level,
                    "Level of tests; intervals hold at one minus it")
        .within(1e-6, 0.5)
        .shows_default();
    command
        .add_option("--replicates", options->analysis.bootstrap_replicates,
                    "How often observers are drawn again for the intervals of the scales")
        .within(100, 1'000'000)
        .shows_default();
    command.add_option("--seed", options->analysis.bootstrap_seed, "Seed of those draws")
        .shows_default();
    add_voice(command, options->voice);
    command.runs([options] { run(*options); });
}

} // namespace experiment::commands
