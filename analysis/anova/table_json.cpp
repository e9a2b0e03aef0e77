#include "analysis/anova/table_json.h"

#include "analysis/anova/rows_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace analysis::anova {

namespace {

using Names = std::vector<std::string>;

// What a design does not have is left out, not null.
void put_if_known(Json& row, const char* name, double value) {
    if (!std::isnan(value))
        row[name] = json_number(value);
}

Json term_json(const TableTerm& term, double level) {
    auto row = variation_json(term.effect);
    if (term.error)
        put_error(row, *term.error);
    put_test(row, term.test);
    put_if_known(row, "eta2", term.eta_squared);
    put_if_known(row, "eta2_partial", term.eta_squared_partial);
    put_if_known(row, "eta2_generalized", term.eta_squared_generalized);
    put_if_known(row, "omega2_partial", term.omega_squared_partial);
    put_if_known(row, "epsilon2", term.epsilon_squared);
    put_eta_interval(row, term.eta_interval, level);
    put_sphericity(row, term.sphericity);
    return row;
}

Json dunnett_json(const DunnettTest& test, const Names& names) {
    Json pairs = Json::array();
    for (const auto& pair : test.pairs)
        pairs.push_back({{"level", names[pair.level]},
                         {"diff", json_number(pair.difference)},
                         {"t", json_number(pair.t)},
                         {"lower", json_number(pair.lower)},
                         {"upper", json_number(pair.upper)},
                         {"p", json_number(pair.p)},
                         {"significant", pair.significant}});
    return {{"control", names[test.control]},
            {"df", json_number(test.df)},
            {"t_crit", json_number(test.t_critical)},
            {"pairs", pairs}};
}

void put_levels(Json& document, const LevelComparisons& found) {
    const auto& names = found.levels;
    Json levels = Json::array();
    for (std::size_t i = 0; i < names.size(); ++i) {
        Json row{{"level", names[i]},
                 {"n", found.n[i]},
                 {"mean", json_number(found.mean[i])},
                 {"sd", json_number(found.sd[i])}};
        if (!found.letters.empty())
            row["letters"] = found.letters[i];
        levels.push_back(row);
    }
    document["levels"] = levels;
    document["tukey_kramer"] = range_test_json(found.tukey, names);
    document[found.welch ? "pooled_t" : "paired_t"] = t_pairs_json(found.t, names);
    if (found.dunnett)
        document["dunnett"] = dunnett_json(*found.dunnett, names);
    if (found.welch) {
        document["games_howell"] = range_pairs_json(found.games_howell, names);
        document["welch"] = test_json(*found.welch);
        document["levene_mean"] = test_json(*found.levene);
        document["brown_forsythe"] = test_json(*found.brown_forsythe);
    }
}

Json factor_json(const FactorComparisons& found) {
    const auto& [place, mean, tukey, t, letters, reason] = found.means;
    Json row{{"within", found.within}};
    put_reason(row, reason);
    if (!reason.empty())
        return row;
    Json levels = Json::array();
    for (std::size_t i = 0; i < found.levels.size(); ++i) {
        levels.push_back({{"level", found.levels[i]}, {"mean", json_number(mean[i])}});
        if (!letters.empty())
            levels.back()["letters"] = letters[i];
    }
    row["levels"] = levels;
    if (tukey)
        row["tukey_kramer"] = range_test_json(*tukey, found.levels);
    row[found.within ? "paired_t" : "pooled_t"] = t_pairs_json(t, found.levels);
    return row;
}

Json factors_json(const TableAnalysis& analysis) {
    Json factors = Json::object();
    for (const auto& factor : analysis.factors)
        factors[factor.factor] = factor_json(factor);
    return factors;
}

} // namespace

std::string table_json(const TableAnalysis& analysis, const std::string& source) {
    Json terms = Json::object();
    for (const auto& term : analysis.terms)
        terms[term.name] = term_json(term, analysis.options.level);
    terms["residual"] = {
        {"SS", json_number(analysis.residual.ss)},
        {"df", json_number(analysis.residual.df)},
        {"MS", analysis.residual.df > 0 ? json_number(analysis.residual.ms()) : Json()},
        {"sd", json_number(analysis.residual_sd)}};
    terms["total"] = {{"SS", json_number(analysis.total.ss)},
                      {"df", json_number(analysis.total.df)}};
    Json document{{"schema", "pairlight-anova-1"},
                  {"source", source},
                  {"response", analysis.columns.response},
                  {"factors", analysis.columns.factors},
                  {"design", analysis.design},
                  {"type", static_cast<int>(analysis.options.type) + 1},
                  {"level", analysis.options.level},
                  {"n", analysis.values}};
    if (analysis.unit_exponent != 0)
        document["unit_exponent"] = analysis.unit_exponent;
    if (analysis.subjects > 0) {
        document["within"] = analysis.columns.subject;
        document["subjects"] = analysis.subjects;
    }
    document["grand_mean"] = json_number(analysis.grand_mean);
    document["terms"] = terms;
    document["r_squared"] = json_number(analysis.r_squared);
    document["shapiro_wilk_of_residuals"] = {{"W", json_number(analysis.normality.w)},
                                             {"p", json_number(analysis.normality.p)}};
    put_reason(document["shapiro_wilk_of_residuals"], analysis.normality.reason);
    if (analysis.levels)
        put_levels(document, *analysis.levels);
    if (!analysis.factors.empty())
        document["marginal_means"] = factors_json(analysis);
    document["notes"] = analysis.notes;
    return document.dump(1) + "\n";
}

} // namespace analysis::anova
