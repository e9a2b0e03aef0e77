// The shared experiment of tests/data/golden/experiment as a report's contents.
#pragma once

#include "analysis/vote_csv.h"
#include "experiment/report/contents.h"
#include "experiment/text_files.h"

#include <filesystem>

namespace experiment::report {

inline analysis::VoteTable shared_votes() {
    const auto file =
        std::filesystem::path(PAIRLIGHT_TEST_DATA) / "golden" / "experiment" / "votes.csv";
    const auto text = read_text_file(file);
    EXPECT_TRUE(text.has_value()) << text.error();
    auto table = analysis::read_votes_csv(*text, "votes.csv");
    EXPECT_TRUE(table.has_value()) << table.error();
    return std::move(*table);
}

inline ReportContents contents_of(const analysis::VoteTable& votes) {
    analysis::AnalysisOptions options;
    options.source = "votes.csv";
    options.source_digest = "0123abcd";
    options.program = "pairlight 0.1.0";
    ReportContents contents;
    contents.title = "A shared experiment";
    contents.question = "Which of the two looks more realistic?";
    contents.written_on = "2026-11-22";
    contents.findings = analysis::analyze(votes, options);
    return contents;
}

inline ReportContents shared_experiment() {
    return contents_of(shared_votes());
}

} // namespace experiment::report
