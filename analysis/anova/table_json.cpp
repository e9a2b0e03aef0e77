#include "analysis/anova/table_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace analysis::anova {

namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

Json number(double value) {
    if (std::isnan(value))
        return nullptr;
    if (std::isinf(value))
        return value > 0 ? "inf" : "-inf";
    return value;
}

void put_test(Json& row, const FTest& test) {
    row["F"] = number(test.f);
    row["p"] = number(test.p);
    if (test.p < 1e-300)
        row["log10_p"] = number(test.log10_p);
    if (!test.reason.empty())
        row["reason"] = test.reason;
}

// What a design does not have is left out, not null.
void put_if_known(Json& row, const char* name, double value) {
    if (!std::isnan(value))
        row[name] = number(value);
}

void put_sphericity(Json& row, const Sphericity& s) {
    if (std::isnan(s.greenhouse_geisser)) {
        if (!s.reason.empty())
            row["sphericity_reason"] = s.reason;
        return;
    }
    put_if_known(row, "mauchly_W", s.mauchly_w);
    put_if_known(row, "mauchly_p_box2", s.p_second_order);
    if (std::isnan(s.mauchly_w))
        row["mauchly_reason"] = s.reason;
    row["GG"] = number(s.greenhouse_geisser);
    row["HF_raw"] = number(s.huynh_feldt_raw);
    row["HF"] = number(s.huynh_feldt);
    row["p_GG"] = number(s.p_greenhouse_geisser);
    row["p_HF"] = number(s.p_huynh_feldt);
    row["p_lower_bound"] = number(s.p_lower_bound);
}

Json term_json(const TableTerm& term, double level) {
    Json row{{"SS", number(term.effect.ss)},
             {"df", number(term.effect.df)},
             {"MS", term.effect.df > 0 ? number(term.effect.ms()) : Json()}};
    if (term.error) {
        row["SS_error"] = number(term.error->ss);
        row["df_error"] = number(term.error->df);
        row["MS_error"] = number(term.error->ms());
    }
    put_test(row, term.test);
    put_if_known(row, "eta2", term.eta_squared);
    put_if_known(row, "eta2_partial", term.eta_squared_partial);
    put_if_known(row, "eta2_generalized", term.eta_squared_generalized);
    put_if_known(row, "omega2_partial", term.omega_squared_partial);
    put_if_known(row, "epsilon2", term.epsilon_squared);
    if (!std::isnan(term.eta_interval.lower))
        row["eta2_partial_interval"] = {{"level", 1 - level},
                                        {"lower", number(term.eta_interval.lower)},
                                        {"upper", number(term.eta_interval.upper)}};
    put_sphericity(row, term.sphericity);
    return row;
}

Json check(const FTest& test) {
    Json row{{"F", number(test.f)},
             {"df1", number(test.df1)},
             {"df2", number(test.df2)},
             {"p", number(test.p)}};
    if (!test.reason.empty())
        row["reason"] = test.reason;
    return row;
}

Json range_pairs(const std::vector<RangePair>& pairs, const Names& names) {
    Json rows = Json::array();
    for (const auto& pair : pairs) {
        Json row{{"a", names[pair.first]},          {"b", names[pair.second]},
                 {"diff", number(pair.difference)}, {"se_q", number(pair.standard_error)},
                 {"df", number(pair.df)},           {"q", number(pair.q)}};
        put_if_known(row, "lower", pair.lower);
        put_if_known(row, "upper", pair.upper);
        row["p"] = number(pair.p);
        if (pair.p < 1e-300)
            row["log10_p"] = number(pair.log10_p);
        row["significant"] = pair.significant;
        rows.push_back(row);
    }
    return rows;
}

Json t_pairs(const std::vector<TPair>& pairs, const Names& names) {
    Json rows = Json::array();
    for (const auto& pair : pairs)
        rows.push_back({{"a", names[pair.first]},
                        {"b", names[pair.second]},
                        {"mean_diff", number(pair.difference)},
                        {"t", number(pair.t)},
                        {"df", number(pair.df)},
                        {"p_raw", number(pair.p)},
                        {"p_bonferroni", number(pair.p_bonferroni)},
                        {"p_holm", number(pair.p_holm)},
                        {"p_hochberg", number(pair.p_hochberg)},
                        {"p_bh", number(pair.p_benjamini_hochberg)}});
    return rows;
}

Json dunnett_json(const DunnettTest& test, const Names& names) {
    Json pairs = Json::array();
    for (const auto& pair : test.pairs)
        pairs.push_back({{"level", names[pair.level]},
                         {"diff", number(pair.difference)},
                         {"t", number(pair.t)},
                         {"lower", number(pair.lower)},
                         {"upper", number(pair.upper)},
                         {"p", number(pair.p)},
                         {"significant", pair.significant}});
    return {{"control", names[test.control]},
            {"df", number(test.df)},
            {"t_crit", number(test.t_critical)},
            {"pairs", pairs}};
}

void put_levels(Json& document, const LevelComparisons& found) {
    const auto& names = found.levels;
    Json levels = Json::array();
    for (std::size_t i = 0; i < names.size(); ++i) {
        Json row{{"level", names[i]},
                 {"n", found.n[i]},
                 {"mean", number(found.mean[i])},
                 {"sd", number(found.sd[i])}};
        if (!found.letters.empty())
            row["letters"] = found.letters[i];
        levels.push_back(row);
    }
    document["levels"] = levels;
    document["tukey_kramer"] = {{"level", found.tukey.level},
                                {"q_crit", number(found.tukey.q_critical)},
                                {"k", found.tukey.groups},
                                {"df", number(found.tukey.df)},
                                {"MSE", number(found.tukey.mean_square_error)},
                                {"pairs", range_pairs(found.tukey.pairs, names)}};
    document[found.welch ? "pooled_t" : "paired_t"] = t_pairs(found.t, names);
    if (found.dunnett)
        document["dunnett"] = dunnett_json(*found.dunnett, names);
    if (found.welch) {
        document["games_howell"] = range_pairs(found.games_howell, names);
        document["welch"] = check(*found.welch);
        document["levene_mean"] = check(*found.levene);
        document["brown_forsythe"] = check(*found.brown_forsythe);
    }
}

} // namespace

std::string table_json(const TableAnalysis& analysis, const std::string& source) {
    Json terms = Json::object();
    for (const auto& term : analysis.terms)
        terms[term.name] = term_json(term, analysis.options.level);
    terms["residual"] = {{"SS", number(analysis.residual.ss)},
                         {"df", number(analysis.residual.df)},
                         {"MS", analysis.residual.df > 0 ? number(analysis.residual.ms()) : Json()},
                         {"sd", number(analysis.residual_sd)}};
    terms["total"] = {{"SS", number(analysis.total.ss)}, {"df", number(analysis.total.df)}};
    Json document{{"schema", "pairlight-anova-1"},
                  {"source", source},
                  {"response", analysis.columns.response},
                  {"factors", analysis.columns.factors},
                  {"design", analysis.design},
                  {"type", static_cast<int>(analysis.options.type) + 1},
                  {"level", analysis.options.level},
                  {"n", analysis.values}};
    if (analysis.subjects > 0) {
        document["within"] = analysis.columns.subject;
        document["subjects"] = analysis.subjects;
    }
    document["grand_mean"] = number(analysis.grand_mean);
    document["terms"] = terms;
    document["r_squared"] = number(analysis.r_squared);
    document["shapiro_wilk_of_residuals"] = {{"W", number(analysis.normality.w)},
                                             {"p", number(analysis.normality.p)}};
    if (!analysis.normality.reason.empty())
        document["shapiro_wilk_of_residuals"]["reason"] = analysis.normality.reason;
    if (analysis.levels)
        put_levels(document, *analysis.levels);
    document["notes"] = analysis.notes;
    return document.dump(1) + "\n";
}

} // namespace analysis::anova
