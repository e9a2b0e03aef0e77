#include "analysis/findings_anova_json.h"

#include "analysis/anova/rows_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace analysis {

namespace {

using anova::json_number;
using anova::put_reason;
using anova::put_test;
using anova::test_json;
using anova::variation_json;
using Json = anova::Json;
using Names = std::vector<std::string>;

Json one_way(const anova::OneWay& table, const anova::EtaInterval& interval, double level) {
    Json means = Json::array();
    for (const auto mean : table.mean)
        means.push_back(json_number(mean));
    Json row{{"k", table.n.size()},
             {"N", table.between.df + table.within.df + 1},
             {"n", table.n},
             {"mean", means},
             {"grand_mean", json_number(table.grand_mean)},
             {"SS_between", json_number(table.between.ss)},
             {"df_between", json_number(table.between.df)},
             {"MS_between", json_number(table.between.ms())},
             {"SS_within", json_number(table.within.ss)},
             {"df_within", json_number(table.within.df)},
             {"MS_within", json_number(table.within.ms())}};
    put_test(row, table.test);
    row["residual_sd"] = json_number(table.residual_sd);
    row["eta2"] = json_number(table.eta_squared);
    anova::put_eta_interval(row, interval, level);
    row["omega2"] = json_number(table.omega_squared);
    row["epsilon2"] = json_number(table.epsilon_squared);
    return row;
}

Json letters(const std::vector<std::string>& words, const Names& names) {
    Json by_name = Json::object();
    for (std::size_t i = 0; i < words.size(); ++i)
        by_name[names[i]] = words[i];
    return by_name;
}

// "0.05" is written 005 in key names.
std::string level_suffix(double level) {
    auto digits = Json(level).dump();
    std::erase(digits, '.');
    return digits;
}

Json one_way_findings(const OneWayFindings& found, const Names& names, double level) {
    const auto suffix = level_suffix(level);
    return {{"unit", found.unit},
            {"anova", one_way(found.anova, found.eta_interval, level)},
            {"levene_mean", test_json(found.levene)},
            {"brown_forsythe", test_json(found.brown_forsythe)},
            {"welch", test_json(found.welch)},
            {"tukey_kramer", anova::range_test_json(found.tukey, names)},
            {"letters_tukey_" + suffix, letters(found.letters, names)},
            {"pooled_t", anova::t_pairs_json(found.pooled_t, names)},
            {"games_howell", anova::range_pairs_json(found.games_howell, names)},
            {"comparison_half_width_" + suffix, json_number(found.tukey.comparison_half_width)}};
}

Json two_way(const TwoWayFixed& table) {
    Json rows = Json::object();
    for (const auto& fixed : table.rows) {
        auto row = variation_json(fixed.variation);
        put_test(row, fixed.test);
        row["eta2"] = json_number(fixed.eta_squared);
        row["eta2_partial"] = json_number(fixed.eta_squared_partial);
        row["omega2_partial"] = json_number(fixed.omega_squared_partial);
        rows[fixed.name] = row;
    }
    rows["residual"] = variation_json(table.residual);
    rows["total"] = {{"SS", json_number(table.total.ss)}, {"df", json_number(table.total.df)}};
    return rows;
}

Json within(const anova::WithinAnalysis& analysis, double level) {
    Json rows = Json::object();
    for (const auto& effect : analysis.effects) {
        auto row = variation_json(effect.effect);
        anova::put_error(row, effect.error);
        put_test(row, effect.test);
        row["eta2_partial"] = json_number(effect.eta_squared_partial);
        anova::put_eta_interval(row, effect.eta_interval, level);
        row["eta2_generalized"] = json_number(effect.eta_squared_generalized);
        anova::put_sphericity(row, effect.sphericity);
        rows[effect.name] = row;
    }
    rows["(subject)"] = {{"SS", json_number(analysis.subject.ss)},
                         {"df", json_number(analysis.subject.df)}};
    rows["(total)"] = {{"SS", json_number(analysis.total.ss)},
                       {"df", json_number(analysis.total.df)}};
    return rows;
}

Json transformed(const anova::WithinAnalysis& analysis) {
    const auto& effect = analysis.effects[0];
    Json row{{"SS", json_number(effect.effect.ss)},
             {"df", json_number(effect.effect.df)},
             {"SS_error", json_number(effect.error.ss)},
             {"df_error", json_number(effect.error.df)},
             {"SS_observer", json_number(analysis.subject.ss)}};
    put_test(row, effect.test);
    return row;
}

Json mixed_row(const anova::Variation& part, const anova::FTest& test) {
    Json row{{"SS", json_number(part.ss)}, {"df", json_number(part.df)}};
    put_test(row, test);
    return row;
}

Json mixed(const anova::MixedAnalysis& table) {
    auto group = mixed_row(table.group, table.group_test);
    group["SS_error"] = json_number(table.group_error.ss);
    group["df_error"] = json_number(table.group_error.df);
    Json sphericity = Json::object();
    anova::put_sphericity(sphericity, table.sphericity);
    return {{"group", group},
            {"method_type3", mixed_row(table.method_unweighted, table.method_unweighted_test)},
            {"method_type2_or_1", mixed_row(table.method_weighted, table.method_weighted_test)},
            {"group_x_method", mixed_row(table.group_x_method, table.group_x_method_test)},
            {"within_error", variation_json(table.within_error)},
            {"sphericity", sphericity}};
}

Json friedman(const consistency::RankTest& test) {
    Json row{{"b", test.blocks},
             {"k", test.conditions},
             {"rank_sums", test.rank_sums},
             {"chi2", json_number(test.chi_squared)},
             {"df", json_number(test.df)},
             {"p", json_number(test.p)},
             {"kendall_W", json_number(test.kendall_w)},
             {"iman_davenport_F", json_number(test.f)},
             {"p_F", json_number(test.p_f)}};
    put_reason(row, test.reason);
    return row;
}

Json nemenyi(const consistency::Nemenyi& test, const Names& names, double level) {
    Json pairs = Json::array();
    for (const auto& pair : test.pairs)
        pairs.push_back({{"a", names[pair.first]},
                         {"b", names[pair.second]},
                         {"mean_rank_diff", json_number(pair.mean_rank_difference)},
                         {"q", json_number(pair.q)},
                         {"p", json_number(pair.p)}});
    return {{"critical_difference_" + level_suffix(level), json_number(test.critical_difference)},
            {"pairs", pairs}};
}

Json anovas(const Findings& findings) {
    const auto& names = findings.design.conditions;
    const double level = findings.options.level;
    Json tables = Json::object();
    if (findings.within.empty()) {
        tables["reason"] = findings.why_no_anova;
        return tables;
    }
    tables["default"] = {{"test", "rm_method"}, {"level", level}, {"unit_of_analysis", "observer"}};
    if (findings.one_way_rounds)
        tables["oneway_rounds_pseudoreplicated"] =
            one_way_findings(*findings.one_way_rounds, names, level);
    if (findings.one_way_observers)
        tables["oneway_observer_means"] =
            one_way_findings(*findings.one_way_observers, names, level);
    if (findings.two_way)
        tables["twoway_method_" + findings.two_way->factor + "_fixed"] = two_way(*findings.two_way);
    for (const auto& named : findings.within)
        tables[named.name] = within(named.analysis, level);
    tables["rm_method_tukey"] = anova::range_test_json(findings.within_tukey, names);
    tables["rm_method_letters_" + level_suffix(level)] = letters(findings.within_letters, names);
    tables["paired_t"] = anova::t_pairs_json(findings.paired_t, names);
    tables["rm_method_residuals"] = {{"fitted", findings.residuals.fitted},
                                     {"residual", findings.residuals.residual},
                                     {"shapiro_W", json_number(findings.residuals.normality.w)},
                                     {"shapiro_p", json_number(findings.residuals.normality.p)}};
    put_reason(tables["rm_method_residuals"], findings.residuals.normality.reason);
    const auto& parts = findings.components;
    tables["variance_components"] = {{"method", json_number(parts.condition)},
                                     {"observer_x_method", json_number(parts.observer_x_condition)},
                                     {"session_within_observer", json_number(parts.repetition)},
                                     {"inter_observer_sd", json_number(parts.inter_observer_sd)},
                                     {"intra_observer_sd", json_number(parts.intra_observer_sd)},
                                     {"reliability_of_means", json_number(parts.reliability)}};
    put_reason(tables["variance_components"], parts.reason);
    const auto& permutation = findings.permutation;
    tables["permutation_of_labels"] = {{"statistic", "rm_method F"},
                                       {"seed", findings.options.permutation_seed},
                                       {"arrangements", permutation.arrangements},
                                       {"as_large", permutation.as_large},
                                       {"complete", permutation.complete},
                                       {"p", permutation.p}};
    for (const auto& named : findings.transformed)
        tables[named.name] = transformed(named.analysis);
    if (findings.mixed)
        tables["mixed_" + findings.options.group_name + "_method"] = mixed(*findings.mixed);
    return tables;
}

} // namespace

std::string anova_json(const Findings& findings) {
    return anovas(findings).dump();
}

std::string friedman_json(const Findings& findings) {
    return friedman(*findings.friedman).dump();
}

std::string nemenyi_json(const Findings& findings) {
    return nemenyi(findings.nemenyi, findings.design.conditions, findings.options.level).dump();
}

} // namespace analysis
