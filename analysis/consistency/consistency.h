// Everything about consistency and agreement, for one table of votes.
#pragma once

#include "analysis/consistency/agreement.h"
#include "analysis/consistency/equality.h"
#include "analysis/consistency/rank_tests.h"
#include "analysis/consistency/repeatability.h"
#include "analysis/vote_table.h"

#include <optional>
#include <string>
#include <vector>

namespace analysis::consistency {

struct NamedZeta {
    std::string name;
    double mean = 0;
};

/// Rounds are the complete ones with one answer per pair.
struct TriadSummary {
    std::int64_t rounds = 0;
    std::int64_t rounds_left_out = 0;
    std::int64_t rounds_with_ties = 0;
    double mean_zeta = 0;
    std::int64_t total = 0;
    double expected_if_random = 0;
    double z = 0;                               ///< of the total, normal approximation
    std::vector<std::int64_t> rounds_by_triads; ///< how many rounds have 0, 1, 2.. triads
    std::vector<NamedZeta> by_observer;
    std::vector<NamedZeta> by_session;
};

struct ScopedAgreement {
    std::string session;            ///< "" when pooled
    std::vector<std::string> scene; ///< one per factor, "" when pooled
    Agreement agreement;
};

struct NamedVoteTests {
    std::string level; ///< of the first scene factor
    EqualityTest equality;
    VoteRangeTest range;
};

struct Consistency {
    TriadSummary triads;
    /// Judges are independent observers only in the first; in the others an observer counts as
    /// several judges, which is common in print.
    std::vector<ScopedAgreement> observers_as_judges; ///< per session and scene
    std::vector<ScopedAgreement> sessions_as_judges;  ///< per scene
    std::vector<ScopedAgreement> scenes_as_judges;    ///< per session
    std::optional<EqualityTest> equality;             ///< nothing when incomplete
    std::optional<VoteRangeTest> range;
    std::vector<NamedVoteTests> by_factor;
    Repeatability repeatability;
    SideBias side;
};

Consistency summarize(const VoteTable& table);

} // namespace analysis::consistency
