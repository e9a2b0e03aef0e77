// pairlight anova: analysis of variance of any table of numbers.
#include "analysis/anova/table_json.h"
#include "analysis/anova/table_text.h"
#include "analysis/numerics/nist_file.h"
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/text_files.h"

#include <fmt/core.h>

#include <memory>

namespace experiment::commands {

namespace {

namespace anova = analysis::anova;

struct Options {
    std::string table;
    anova::MeasurementColumns columns;
    int type = 2;
    double level = 0.05;
    std::string control;
    bool nist = false;
    std::string json;
    Voice voice;
};

anova::Measurements from_nist(const std::string& text, const std::string& name) {
    auto set = value_or_stop(analysis::numerics::read_nist_one_way(text, name));
    anova::Measurements table;
    table.names = {set.response_name, {set.factor_name}, ""};
    table.levels.resize(1);
    table.factor.resize(1);
    for (std::size_t g = 0; g < set.groups.size(); ++g)
        for (const auto& value : set.groups[g]) {
            table.response.push_back(value);
            table.factor[0].push_back(table.levels[0].code(set.labels[g]));
        }
    return table;
}

anova::Measurements read(const Options& options) {
    const auto text = value_or_stop(read_text_file(options.table));
    if (options.nist)
        return from_nist(text, options.table);
    if (options.columns.response.empty() || options.columns.factors.empty())
        throw CommandError("expected --response COLUMN and --factor COLUMN, or --nist");
    return value_or_stop(anova::read_measurements(text, options.table, options.columns));
}

void run(const Options& options) {
    const auto table = read(options);
    auto analysis =
        anova::analyze_table(table, {static_cast<anova::SumsOfSquares>(options.type - 1),
                                     options.level, options.control});
    if (!analysis)
        throw CommandError(options.table + ": " + analysis.error());
    if (!options.json.empty())
        deliver(anova::table_json(*analysis, options.table), options.json, {options.table});
    if (options.voice.says_text_beside(options.json))
        fmt::print("{}", anova::table_text(*analysis));
}

} // namespace

void add_anova(Command& program) {
    const auto options = std::make_shared<Options>();
    auto command = program.add_command("anova", "Analysis of variance of a table of numbers");
    command.add_option("TABLE.csv", options->table, "A table with a header row; a row per value")
        .required();
    command.add_option("--response", options->columns.response, "The column of values");
    command.add_option("--factor", options->columns.factors,
                       "A column of levels; once for every factor");
    command.add_option("--within", options->columns.subject,
                       "The column of whoever was measured again and again, such as observer: "
                       "factors that vary within it are tested within it");
    command.add_option("--type", options->type, "Type of the sums of squares: 1, 2 or 3")
        .within(1, 3)
        .shows_default();
    command.add_option("--level", options->level, "Level of the tests")
        .within(1e-12, 0.5)
        .shows_default();
    command.add_option("--control", options->control,
                       "Compare the levels of a single factor with this one (Dunnett)");
    command.add_flag("--nist", options->nist,
                     "TABLE is a reference data set in NIST's own text form");
    command.add_option("--json", options->json,
                       "Write the analysis here, all digits; - is standard output");
    add_voice(command, options->voice);
    command.runs([options] { run(*options); });
}

} // namespace experiment::commands
