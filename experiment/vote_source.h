// Votes for the analysis, from wherever they lie: a study's store, or a table made elsewhere.
#pragma once

#include "analysis/formats/vote_files.h"
#include "analysis/vote_table.h"
#include "experiment/read_study.h"
#include "experiment/store/vote_store.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace experiment {

struct VoteSource {
    analysis::VoteTable table;
    std::string name; ///< as a person would say it
    std::string
        sha256; ///< of the bytes the votes came from: the CSV file, or the long table of the store
    std::optional<LoadedStudy> study; ///< where the votes are a study's own
};

/// `path` is a study (folder or study.toml) or a table of votes, in `format`.
/// Errors: "<file>[:<line>]: ..."; a study without votes.
tl::expected<VoteSource, std::string>
read_votes(const std::filesystem::path& path,
           analysis::formats::VoteFormat format = analysis::formats::VoteFormat::Detect,
           analysis::Repeats repeats = analysis::Repeats::Refuse);

/// A study's store, after its record was found whole: an analysis of damaged votes is worth
/// nothing. Errors: no store; one that cannot be read; one with faults, and how to list them.
tl::expected<std::unique_ptr<store::VoteStore>, std::string>
open_whole_votes(const StudyFolder& folder);

/// Every main vote of a study, in the order of the store.
tl::expected<std::vector<store::VoteRow>, std::string> stored_votes(const LoadedStudy& loaded);

/// `study,observer,session,trial,scene,variant,left,right,chosen,rt_ms,onset_utc`, and, as soon as
/// any vote is simulated, `simulated` (0 or 1) behind them.
std::string long_csv(const std::vector<store::VoteRow>& rows);

} // namespace experiment
