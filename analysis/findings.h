// Everything an analysis says about a table of votes, as one value.
// NaN marks a number that is not defined; the reason stands beside it.
#pragma once

#include "analysis/anova/comparisons.h"
#include "analysis/anova/effect_size.h"
#include "analysis/anova/mixed.h"
#include "analysis/anova/one_way.h"
#include "analysis/anova/permutation.h"
#include "analysis/anova/residuals.h"
#include "analysis/anova/variance_components.h"
#include "analysis/anova/within_observers.h"
#include "analysis/consistency/consistency.h"
#include "analysis/consistency/screening.h"
#include "analysis/pair_coverage.h"
#include "analysis/paper_score.h"
#include "analysis/scaling/scales.h"
#include "analysis/vote_matrix.h"
#include "analysis/vote_table.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace analysis {

struct AnalysisOptions {
    double level = 0.05;       ///< of every test and interval
    std::string source;        ///< where the votes came from, as a person would say it
    std::string source_digest; ///< hash of that source, "" when unknown
    std::string program;       ///< name and version
    std::uint64_t permutation_seed = 20120924; ///< for designs too large to enumerate
    std::uint64_t bootstrap_seed = 20120924;
    int bootstrap_replicates = 2000;
    std::string group_name;                    ///< of `groups`, e.g. "sex"; "" for none
    std::map<std::string, std::string> groups; ///< observer to group, for every observer
};

/// What was asked, of whom, and what is missing.
struct DesignFacts {
    std::string study;
    bool simulated = false; ///< at least one vote is not a person's; say so wherever votes show
    std::vector<std::string> conditions; ///< order of first appearance; indices below refer to it
    std::vector<std::string> observers;
    std::vector<std::string> sessions;
    std::vector<std::string> factor_names;         ///< what makes a scene, e.g. model, light
    std::vector<std::vector<std::string>> factors; ///< levels of each
    std::int64_t scenes = 0; ///< combinations of factor levels that were shown
    std::int64_t rounds = 0; ///< observer, session and scene with at least one vote
    std::int64_t votes = 0;
    std::int64_t ties = 0;
    std::int64_t missing = 0;  ///< votes short of every pair in every scene of every observer
    bool missing_known = true; ///< false when nobody finished a scene: `missing` says nothing
    std::int64_t skipped_not_main = 0;
    bool complete = false; ///< every observer compared every pair equally often in every scene
    std::vector<std::string> incomplete_observers; ///< left out of the analyses of variance
};

/// One condition's place in the ranking.
struct RankedCondition {
    std::size_t condition = 0;
    double rank = 0;
    double votes = 0;
    double mean_votes = 0; ///< per round
    double share = 0;
    double lower = anova::undefined; ///< t interval of mean_votes over observers
    double upper = anova::undefined;
    std::string letters; ///< within-observer Tukey at the level; "" when not computed
};

/// A one-way analysis and what is read from it.
struct OneWayFindings {
    std::string unit; ///< what one value is: "observer mean" or "round"
    anova::OneWay anova;
    anova::EtaInterval eta_interval; ///< of eta squared
    anova::RangeTest tukey;
    std::vector<anova::TPair> pooled_t;
    std::vector<anova::RangePair> games_howell;
    std::vector<std::string> letters; ///< by condition; empty when too many are needed
    anova::FTest levene;
    anova::FTest brown_forsythe;
    anova::FTest welch;
};

/// A row of the method x factor table with one pooled residual.
struct FixedRow {
    std::string name;
    anova::Variation variation;
    anova::FTest test;
    double eta_squared = anova::undefined;
    double eta_squared_partial = anova::undefined;
    double omega_squared_partial = anova::undefined;
};

struct TwoWayFixed {
    std::string factor;
    std::vector<FixedRow> rows; ///< method, factor, method_x_factor
    anova::Variation residual;
    anova::Variation total;
};

/// A within-observer analysis under the name it has in the machine output, e.g. "rm_method_model".
struct NamedWithin {
    std::string name;
    anova::WithinAnalysis analysis;
};

/// A sentence for the reader.  `about` names the part it belongs to: "design", "within", "one_way",
/// "two_way", "pairs", "scores", "scales", "screening", "units".
struct Note {
    std::string about;
    std::string text;
};

struct Findings {
    AnalysisOptions options;
    DesignFacts design;
    PairCoverage coverage;
    std::vector<ScopedMatrix> matrices;   ///< all, each observer, session, factor level, scene, ...
    std::vector<PaperScore> scores;       ///< by condition
    std::vector<RankedCondition> ranking; ///< best first

    /// The default analysis: observer means, method within observers.  `why_no_anova` says why it
    /// and everything after it is empty.
    std::string why_no_anova;
    std::vector<NamedWithin> within; ///< [0] is "rm_method"
    anova::RangeTest within_tukey;
    std::vector<std::string> within_letters; ///< by condition; empty when too many are needed
    std::vector<anova::TPair> paired_t;
    anova::WithinResiduals residuals; ///< of the default analysis
    anova::VarianceComponents components;

    std::optional<OneWayFindings> one_way_observers; ///< as in the paper
    std::optional<OneWayFindings> one_way_rounds;    ///< as in the paper, pseudo-replicated
    std::optional<TwoWayFixed> two_way;              ///< method x first scene factor

    anova::Permutation permutation; ///< labels within observers: no assumption about votes

    /// The default analysis on transformed shares: votes near 0 and t - 1 vary less.
    std::vector<NamedWithin> transformed;
    std::optional<anova::MixedAnalysis> mixed;     ///< when the options name groups
    std::optional<consistency::RankTest> friedman; ///< observer means, no normality assumed
    consistency::Nemenyi nemenyi;
    consistency::Consistency consistency;
    scaling::Scales scales;
    std::vector<consistency::ObserverScreening> screening; ///< by observer

    std::vector<Note> notes;

    /// The default analysis's effect of method; nothing when it was not computed.
    const anova::WithinEffect* method_effect() const;
};

/// Everything this module knows to say about `table`.  What a design does not allow is left out
/// with its reason; nothing throws over data.  EXPECTS a table with at least one vote.
Findings analyze(const VoteTable& table, const AnalysisOptions& options = {});

} // namespace analysis
