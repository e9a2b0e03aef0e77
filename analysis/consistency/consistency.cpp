#include "analysis/consistency/consistency.h"

#include "analysis/consistency/triads.h"
#include "analysis/vote_matrix.h"

#include <cmath>
#include <limits>
#include <map>

namespace analysis::consistency {

namespace {

// A sum of triads over rounds; the mean zeta follows from the integers.
struct TriadSum {
    std::int64_t triads = 0;
    std::int64_t rounds = 0;

    double mean_zeta(std::int64_t t) const {
        const auto most = most_triads(t) * rounds;
        return most > 0 ? to_double({most - triads, most})
                        : std::numeric_limits<double>::quiet_NaN();
    }
};

std::vector<NamedZeta>
zetas(const Dictionary& names, const std::map<std::string, TriadSum>& sums, std::int64_t t) {
    std::vector<NamedZeta> means;
    for (const auto& name : names.names())
        if (const auto found = sums.find(name); found != sums.end())
            means.push_back({name, found->second.mean_zeta(t)});
    return means;
}

TriadSummary triad_summary(const VoteTable& table) {
    const auto t = static_cast<std::int64_t>(table.conditions.size());
    TriadSummary summary;
    TriadSum all;
    std::map<std::string, TriadSum> observers, sessions;
    const Scope rounds{true, true, std::vector<bool>(table.factors.size(), true)};
    for (const auto& round : count_votes(table, rounds)) {
        const auto triads = circular_triads(round.matrix);
        if (!triads) {
            ++summary.rounds_left_out;
            continue;
        }
        summary.rounds_with_ties += round.matrix.total_ties() > 0 ? 1 : 0;
        const auto count = static_cast<std::size_t>(*triads);
        if (summary.rounds_by_triads.size() <= count)
            summary.rounds_by_triads.resize(count + 1);
        ++summary.rounds_by_triads[count];
        for (auto* sum : {&all, &observers[round.observer], &sessions[round.session]}) {
            sum->triads += *triads;
            ++sum->rounds;
        }
    }
    const auto n = static_cast<double>(all.rounds);
    summary.rounds = all.rounds;
    summary.total = all.triads;
    summary.mean_zeta = all.mean_zeta(t);
    summary.expected_if_random = n * expected_triads(t);
    summary.z = (static_cast<double>(all.triads) - summary.expected_if_random) /
                std::sqrt(n * triads_variance(t));
    summary.by_observer = zetas(table.observers, observers, t);
    summary.by_session = zetas(table.sessions, sessions, t);
    return summary;
}

std::vector<ScopedAgreement> agreements(const VoteTable& table, bool session, bool scene) {
    std::vector<ScopedAgreement> result;
    const Scope scope{false, session, std::vector<bool>(table.factors.size(), scene)};
    for (const auto& cell : count_votes(table, scope))
        result.push_back({cell.session, cell.scene, agreement(cell.matrix)});
    return result;
}

std::vector<NamedVoteTests> vote_tests_by_factor(const VoteTable& table) {
    std::vector<NamedVoteTests> result;
    if (table.factors.empty() || table.factors[0].size() < 2)
        return result;
    for (const auto& cell : count_votes(table, {false, false, {true}}))
        if (cell.matrix.complete() > 0)
            result.push_back({cell.scene[0], david_equality(cell.matrix), range_test(cell.matrix)});
    return result;
}

} // namespace

Consistency summarize(const VoteTable& table) {
    Consistency result;
    result.triads = triad_summary(table);
    result.observers_as_judges = agreements(table, true, true);
    result.sessions_as_judges = agreements(table, false, true);
    result.scenes_as_judges = agreements(table, true, false);
    if (const auto all = count_votes(table); all.complete() > 0) {
        result.equality = david_equality(all);
        result.range = range_test(all);
    }
    result.by_factor = vote_tests_by_factor(table);
    result.repeatability = repeatability(table);
    result.side = side_bias(table);
    return result;
}

} // namespace analysis::consistency
