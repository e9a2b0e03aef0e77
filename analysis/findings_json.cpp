#include "analysis/findings_json.h"

#include "analysis/anova/rows_json.h"
#include "analysis/consistency/consistency_json.h"
#include "analysis/consistency/screening_json.h"
#include "analysis/findings_anova_json.h"
#include "analysis/scaling/scales_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace analysis {

namespace {

using anova::json_number;
using Json = anova::Json;

Json design(const DesignFacts& facts) {
    Json factors = Json::object();
    for (std::size_t f = 0; f < facts.factor_names.size(); ++f)
        factors[facts.factor_names[f]] = facts.factors[f];
    return {{"study", facts.study},
            {"simulated", facts.simulated},
            {"conditions", facts.conditions},
            {"observers", facts.observers},
            {"sessions", facts.sessions},
            {"factors", factors},
            {"scenes", facts.scenes},
            {"rounds", facts.rounds},
            {"votes", facts.votes},
            {"ties", facts.ties},
            {"missing", facts.missing_known ? Json(facts.missing) : Json()},
            {"training_and_warmup_rows_passed_over", facts.skipped_not_main},
            {"complete", facts.complete},
            {"incomplete_observers", facts.incomplete_observers}};
}

Json paper_score(const Findings& findings) {
    const std::string factor =
        findings.design.factor_names.empty() ? "scene" : findings.design.factor_names[0];
    Json scores = Json::object();
    for (const auto& score : findings.scores)
        scores[score.condition] = {
            {"total_votes", json_number(score.total_votes)},
            {"mean_votes_per_round", json_number(score.mean_votes_per_round)},
            {"max_per_round", json_number(score.max_per_round)},
            {"mean_votes_per_observer_and_" + factor,
             json_number(score.mean_votes_per_observer_and_factor)},
            {"share", json_number(score.share)},
            {"share_pooled", json_number(score.share_pooled)},
            {"sd_over_observer_" + factor + "_cells",
             json_number(score.sd_over_observer_factor_cells)},
            {"sd_over_observers", json_number(score.sd_over_observers)},
            {"se_over_observers", json_number(score.se_over_observers)},
            {"rank", json_number(score.rank)}};
    return scores;
}

Json ranking(const Findings& findings) {
    Json places = Json::array();
    for (const auto& place : findings.ranking)
        places.push_back({{"rank", place.rank},
                          {"method", findings.design.conditions[place.condition]},
                          {"votes", place.votes},
                          {"mean_votes_per_round", json_number(place.mean_votes)},
                          {"share", json_number(place.share)},
                          {"lower", json_number(place.lower)},
                          {"upper", json_number(place.upper)},
                          {"letters", place.letters}});
    return places;
}

Json matrices(const Findings& findings) {
    const auto t = findings.design.conditions.size();
    Json scopes = Json::array();
    for (const auto& scoped : findings.matrices) {
        Json scope{{"scope", scoped.scope}};
        if (!scoped.observer.empty())
            scope["observer"] = scoped.observer;
        if (!scoped.session.empty())
            scope["session"] = scoped.session;
        for (std::size_t f = 0; f < scoped.scene.size(); ++f)
            if (!scoped.scene[f].empty())
                scope[findings.design.factor_names[f]] = scoped.scene[f];
        Json wins = Json::array(), ties = Json::array();
        for (std::size_t i = 0; i < t; ++i) {
            Json row = Json::array(), tied = Json::array();
            for (std::size_t j = 0; j < t; ++j) {
                row.push_back(i == j ? 0 : scoped.matrix.wins(i, j));
                tied.push_back(i == j ? 0 : scoped.matrix.ties(i, j));
            }
            wins.push_back(row);
            ties.push_back(tied);
        }
        scope["votes_row_over_column"] = wins;
        if (findings.design.ties > 0)
            scope["ties"] = ties;
        scopes.push_back(scope);
    }
    return scopes;
}

} // namespace

std::string findings_json(const Findings& findings) {
    Json notes = Json::array();
    for (const auto& note : findings.notes)
        notes.push_back({{"about", note.about}, {"text", note.text}});
    Json document{{"schema", "pairlight-findings-1"},
                  {"program", findings.options.program},
                  {"source", findings.options.source},
                  {"source_digest", findings.options.source_digest},
                  {"design", design(findings.design)},
                  {"paper_score", paper_score(findings)},
                  {"ranking", ranking(findings)},
                  {"anova", Json::parse(anova_json(findings))},
                  {"notes", notes}};
    const auto& names = findings.design.conditions;
    if (findings.friedman) {
        document["friedman_observer_means"] = Json::parse(friedman_json(findings));
        document["nemenyi"] = Json::parse(nemenyi_json(findings));
    }
    document["paired_comparison"] = Json::parse(
        consistency::consistency_json(findings.consistency, names, findings.design.factor_names));
    document["choice_models"] = Json::parse(scaling::scales_json(findings.scales, names));
    document["screening"] = Json::parse(consistency::screening_json(findings.screening));
    document["vote_matrices"] = matrices(findings);
    return document.dump(1) + "\n";
}

} // namespace analysis
