#include "analysis/consistency/consistency_json.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <string>

namespace analysis::consistency {

namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

/// Sessions are numbers where they are counted, as the program counts its own, and names elsewhere.
Json session_json(const std::string& session) {
    int number = 0;
    const auto* end = session.data() + session.size();
    const auto [stop, error] = std::from_chars(session.data(), end, number);
    const bool counted = error == std::errc() && stop == end && std::to_string(number) == session;
    return counted ? Json(number) : Json(session);
}

// NaN becomes null in the text; the findings give reasons where a design can cause it.
Json agreement_row(const ScopedAgreement& cell, const Names& factor_names) {
    Json row = Json::object();
    if (!cell.session.empty())
        row["session"] = session_json(cell.session);
    for (std::size_t f = 0; f < cell.scene.size(); ++f)
        if (!cell.scene[f].empty())
            row[factor_names[f]] = cell.scene[f];
    const auto& a = cell.agreement;
    row["k"] = a.conditions;
    row["m"] = a.judges;
    row["Sigma"] = a.agreeing_pairs;
    row["u"] = a.u;
    row["u_min"] = a.u_min;
    row["chi2_corrected"] = a.chi_squared_corrected;
    row["p_corrected"] = a.p_corrected;
    row["chi2_uncorrected"] = a.chi_squared;
    row["p_uncorrected"] = a.p;
    row["df"] = a.df;
    row["chi2_large_m"] = a.chi_squared_many;
    row["df_large_m"] = a.df_many;
    row["p_large_m"] = a.p_many;
    row["p_exact_sigma_at_least"] = a.p_exact;
    if (!a.reason.empty())
        row["reason"] = a.reason;
    return row;
}

Json agreement_rows(const std::vector<ScopedAgreement>& cells, const Names& factor_names) {
    Json rows = Json::array();
    for (const auto& cell : cells)
        rows.push_back(agreement_row(cell, factor_names));
    return rows;
}

Json equality(const EqualityTest& test) {
    return {{"t", test.conditions},
            {"m", test.votes_per_pair},
            {"D", test.d},
            {"df", test.df},
            {"p", test.p}};
}

Json range(const VoteRangeTest& test, const Names& names) {
    Json pairs = Json::array();
    for (const auto& pair : test.pairs)
        pairs.push_back({{"a", names[pair.first]},
                         {"b", names[pair.second]},
                         {"diff", pair.difference},
                         {"significant_005", pair.significant_005},
                         {"significant_001", pair.significant_001}});
    return {{"t", test.conditions},
            {"m", test.votes_per_pair},
            {"W_0.05", test.w_005},
            {"R_real_0.05", test.real_range_005},
            {"R_crit_0.05", test.critical_range_005},
            {"W_0.01", test.w_001},
            {"R_real_0.01", test.real_range_001},
            {"R_crit_0.01", test.critical_range_001},
            {"P_exact_at_R_crit_0.05", test.exact_level_005},
            {"P_exact_at_R_crit_0.01", test.exact_level_001},
            {"pairs", pairs}};
}

Json by_name(const std::vector<NamedZeta>& zetas) {
    Json means = Json::object();
    for (const auto& zeta : zetas)
        means[zeta.name] = zeta.mean;
    return means;
}

void put_triads(Json& out, const TriadSummary& triads) {
    out["mean_zeta"] = triads.mean_zeta;
    out["total_triads"] = triads.total;
    out["expected_triads_if_random"] = triads.expected_if_random;
    out["triads_z"] = triads.z;
    out["rounds"] = triads.rounds;
    out["rounds_left_out"] = triads.rounds_left_out;
    out["rounds_with_ties"] = triads.rounds_with_ties;
    out["rounds_with_triads"] = triads.rounds_by_triads;
    out["mean_zeta_by_observer"] = by_name(triads.by_observer);
    out["mean_zeta_by_session"] = by_name(triads.by_session);
}

void put_repeatability(Json& out, const Repeatability& repeatability) {
    Json within = Json::object(), between = Json::object();
    for (const auto& observer : repeatability.within) {
        Json row = Json::object();
        for (const auto& pair : observer.sessions)
            row[pair.first + "-" + pair.second] = pair.share;
        row["mean"] = observer.mean;
        row["cohen_kappa_chance_half"] = observer.chance_corrected;
        within[observer.observer] = row;
    }
    for (const auto& pair : repeatability.between)
        between[pair.first + "-" + pair.second] = pair.share;
    out["intra_observer_repeatability"] = within;
    out["inter_observer_agreement_same_session"] = between;
    out["inter_observer_mean"] = repeatability.between_mean;
    out["intra_observer_mean"] = repeatability.within_mean;
}

} // namespace

std::string consistency_json(const Consistency& found, const Names& names, const Names& factors) {
    Json out = Json::object();
    out["note"] = "u, David's D, the range test and the side test take votes as independent: they "
                  "are conditional on these observers";
    put_triads(out, found.triads);
    out["agreement_u_per_scene_session"] = agreement_rows(found.observers_as_judges, factors);
    out["agreement_u_per_scene_sessions_as_judges"] =
        agreement_rows(found.sessions_as_judges, factors);
    out["agreement_u_per_session_scenes_as_judges"] =
        agreement_rows(found.scenes_as_judges, factors);
    if (found.equality) {
        out["david_equality_all"] = equality(*found.equality);
        out["range_test_all"] = range(*found.range, names);
    }
    if (!found.by_factor.empty()) {
        Json equalities = Json::object(), ranges = Json::object();
        for (const auto& level : found.by_factor) {
            equalities[level.level] = equality(level.equality);
            ranges[level.level] = range(level.range, names);
        }
        out["david_equality_by_" + factors[0]] = equalities;
        out["range_test_by_" + factors[0]] = ranges;
    }
    put_repeatability(out, found.repeatability);
    out["left_choices"] = found.side.left;
    out["left_answers"] = found.side.answers;
    out["left_test_z"] = found.side.z;
    out["left_test_p_exact_two_sided"] = found.side.p;
    return out.dump();
}

} // namespace analysis::consistency
