// pairlight export: vote matrices and vote tables, in forms other tools read.
#include "analysis/formats/sureal_writer.h"
#include "analysis/formats/vote_writers.h"
#include "analysis/vote_matrix_csv.h"
#include "experiment/commands/command_line.h"
#include "experiment/commands/commands.h"
#include "experiment/tables.h"
#include "experiment/vote_source.h"

#include <fmt/core.h>

#include <memory>

namespace experiment::commands {

namespace {

enum class Form { Long, Matrices, Scores, Pwcmp, Pairs, PairedComparison, Sureal };

std::string exported(const VoteSource& votes, Form form) {
    switch (form) {
    case Form::Long: // by `export_votes`, from the store's own rows
    case Form::Matrices:
        return analysis::vote_matrices_csv(votes.table);
    case Form::Scores:
        return analysis::scores_csv(votes.table);
    case Form::Pwcmp:
        return analysis::formats::pwcmp_csv(votes.table);
    case Form::Pairs:
        return analysis::formats::pair_counts_csv(votes.table);
    case Form::PairedComparison:
        return value_or_stop(analysis::formats::paired_comparison_csv(votes.table));
    case Form::Sureal:
        return value_or_stop(analysis::formats::sureal_script(votes.table));
    }
    return {};
}

void export_votes(const std::string& study, Form form, const std::string& file) {
    if (form == Form::Long) {
        const auto loaded = value_or_stop(read_study(study));
        return deliver(long_csv(value_or_stop(stored_votes(loaded))), file, files_of(loaded));
    }
    const auto votes = value_or_stop(read_votes(study));
    deliver(exported(votes, form), file, votes.study ? files_of(*votes.study) : Inputs{study});
}

} // namespace

void add_export(Command& program) {
    struct Options {
        std::string study;
        Form form = Form::Long;
        std::string csv;
        Voice voice;
    };

    const auto options = std::make_shared<Options>();
    auto command = program.add_command(
        "export", "Vote matrices and vote tables, as CSV or as other programs read them");
    command.add_option("STUDY", options->study, "Study folder or its study.toml").required();
    command
        .add_choice("--format", options->form,
                    "long: one row per vote; matrices: votes for winner over loser in every scope; "
                    "scores; and as other programs read votes: pwcmp, pairs (BradleyTerry2), "
                    "paired-comparison (psychotools), sureal (its data set, a Python script)",
                    {{"long", Form::Long},
                     {"matrices", Form::Matrices},
                     {"scores", Form::Scores},
                     {"pwcmp", Form::Pwcmp},
                     {"pairs", Form::Pairs},
                     {"paired-comparison", Form::PairedComparison},
                     {"sureal", Form::Sureal}})
        .required();
    command.add_option("--csv", options->csv,
                       "The file to write; without it, or with -, standard output");
    add_voice(command, options->voice);
    command.runs([options] {
        export_votes(options->study, options->form, options->csv);
        if (!is_standard_output(options->csv))
            options->voice.remark(options->csv + ": written");
    });
}

} // namespace experiment::commands
