#include "analysis/findings_anova_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace analysis {

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

void put_reason(Json& row, const std::string& reason) {
    if (!reason.empty())
        row["reason"] = reason;
}

void put_test(Json& row, const anova::FTest& test) {
    row["F"] = number(test.f);
    row["p"] = number(test.p);
    if (test.p < 1e-300)
        row["log10_p"] = number(test.log10_p);
    put_reason(row, test.reason);
}

Json variation(const anova::Variation& part) {
    return {{"SS", number(part.ss)}, {"df", number(part.df)}, {"MS", number(part.ms())}};
}

void put_eta_interval(Json& row, const anova::EtaInterval& interval, double level) {
    if (!std::isnan(interval.lower))
        row["eta2_partial_interval"] = {
            {"level", 1 - level}, {"lower", interval.lower}, {"upper", interval.upper}};
}

Json one_way(const anova::OneWay& table, const anova::EtaInterval& interval, double level) {
    Json means = Json::array();
    for (const auto mean : table.mean)
        means.push_back(number(mean));
    Json row{{"k", table.n.size()},
             {"N", table.between.df + table.within.df + 1},
             {"n", table.n},
             {"mean", means},
             {"grand_mean", number(table.grand_mean)},
             {"SS_between", number(table.between.ss)},
             {"df_between", number(table.between.df)},
             {"MS_between", number(table.between.ms())},
             {"SS_within", number(table.within.ss)},
             {"df_within", number(table.within.df)},
             {"MS_within", number(table.within.ms())}};
    put_test(row, table.test);
    row["residual_sd"] = number(table.residual_sd);
    row["eta2"] = number(table.eta_squared);
    put_eta_interval(row, interval, level);
    row["omega2"] = number(table.omega_squared);
    row["epsilon2"] = number(table.epsilon_squared);
    return row;
}

Json range_test(const anova::RangeTest& test, const Names& names) {
    Json pairs = Json::array();
    for (const auto& pair : test.pairs) {
        Json row{{"a", names[pair.first]},
                 {"b", names[pair.second]},
                 {"diff", number(pair.difference)},
                 {"se_q", number(pair.standard_error)},
                 {"q", number(pair.q)},
                 {"lower", number(pair.lower)},
                 {"upper", number(pair.upper)},
                 {"p", number(pair.p)},
                 {"significant", pair.significant}};
        if (pair.p < 1e-300)
            row["log10_p"] = number(pair.log10_p);
        pairs.push_back(row);
    }
    return {{"level", test.level},   {"q_crit", number(test.q_critical)},     {"k", test.groups},
            {"df", number(test.df)}, {"MSE", number(test.mean_square_error)}, {"pairs", pairs}};
}

Json games_howell(const std::vector<anova::RangePair>& pairs, const Names& names) {
    Json rows = Json::array();
    for (const auto& pair : pairs)
        rows.push_back({{"a", names[pair.first]},
                        {"b", names[pair.second]},
                        {"diff", number(pair.difference)},
                        {"se_q", number(pair.standard_error)},
                        {"df", number(pair.df)},
                        {"q", number(pair.q)},
                        {"p", number(pair.p)}});
    return rows;
}

Json t_pairs(const std::vector<anova::TPair>& pairs, const Names& names) {
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

Json check(const anova::FTest& test) {
    Json row{{"F", number(test.f)},
             {"df1", number(test.df1)},
             {"df2", number(test.df2)},
             {"p", number(test.p)}};
    put_reason(row, test.reason);
    return row;
}

Json one_way_findings(const OneWayFindings& found, const Names& names, double level) {
    const auto suffix = level_suffix(level);
    return {{"unit", found.unit},
            {"anova", one_way(found.anova, found.eta_interval, level)},
            {"levene_mean", check(found.levene)},
            {"brown_forsythe", check(found.brown_forsythe)},
            {"welch", check(found.welch)},
            {"tukey_kramer", range_test(found.tukey, names)},
            {"letters_tukey_" + suffix, letters(found.letters, names)},
            {"pooled_t", t_pairs(found.pooled_t, names)},
            {"games_howell", games_howell(found.games_howell, names)},
            {"comparison_half_width_" + suffix, number(found.tukey.comparison_half_width)}};
}

Json two_way(const TwoWayFixed& table) {
    Json rows = Json::object();
    for (const auto& fixed : table.rows) {
        auto row = variation(fixed.variation);
        put_test(row, fixed.test);
        row["eta2"] = number(fixed.eta_squared);
        row["eta2_partial"] = number(fixed.eta_squared_partial);
        row["omega2_partial"] = number(fixed.omega_squared_partial);
        rows[fixed.name] = row;
    }
    rows["residual"] = variation(table.residual);
    rows["total"] = {{"SS", number(table.total.ss)}, {"df", number(table.total.df)}};
    return rows;
}

void put_sphericity(Json& row, const anova::Sphericity& s) {
    if (std::isnan(s.greenhouse_geisser)) {
        if (!s.reason.empty())
            row["sphericity_reason"] = s.reason;
        return;
    }
    row["mauchly_W"] = number(s.mauchly_w);
    if (std::isnan(s.mauchly_w)) {
        row["mauchly_reason"] = s.reason;
    } else {
        row["mauchly_chi2"] = number(s.chi_squared);
        row["mauchly_df"] = number(s.df);
        row["mauchly_p_chi2"] = number(s.p_chi_squared);
        row["mauchly_p_box2"] = number(s.p_second_order);
        row["mauchly_p_as_R"] = number(s.p_as_r);
    }
    row["GG"] = number(s.greenhouse_geisser);
    row["HF_raw"] = number(s.huynh_feldt_raw);
    row["HF"] = number(s.huynh_feldt);
    row["p_GG"] = number(s.p_greenhouse_geisser);
    row["p_HF"] = number(s.p_huynh_feldt);
    row["p_lower_bound"] = number(s.p_lower_bound);
}

Json within(const anova::WithinAnalysis& analysis, double level) {
    Json rows = Json::object();
    for (const auto& effect : analysis.effects) {
        auto row = variation(effect.effect);
        row["SS_error"] = number(effect.error.ss);
        row["df_error"] = number(effect.error.df);
        row["MS_error"] = number(effect.error.ms());
        put_test(row, effect.test);
        row["eta2_partial"] = number(effect.eta_squared_partial);
        put_eta_interval(row, effect.eta_interval, level);
        row["eta2_generalized"] = number(effect.eta_squared_generalized);
        put_sphericity(row, effect.sphericity);
        rows[effect.name] = row;
    }
    rows["(subject)"] = {{"SS", number(analysis.subject.ss)}, {"df", number(analysis.subject.df)}};
    rows["(total)"] = {{"SS", number(analysis.total.ss)}, {"df", number(analysis.total.df)}};
    return rows;
}

Json transformed(const anova::WithinAnalysis& analysis) {
    const auto& effect = analysis.effects[0];
    Json row{{"SS", number(effect.effect.ss)},
             {"df", number(effect.effect.df)},
             {"SS_error", number(effect.error.ss)},
             {"df_error", number(effect.error.df)},
             {"SS_observer", number(analysis.subject.ss)}};
    put_test(row, effect.test);
    return row;
}

Json mixed_row(const anova::Variation& part, const anova::FTest& test) {
    Json row{{"SS", number(part.ss)}, {"df", number(part.df)}};
    put_test(row, test);
    return row;
}

Json mixed(const anova::MixedAnalysis& table) {
    auto group = mixed_row(table.group, table.group_test);
    group["SS_error"] = number(table.group_error.ss);
    group["df_error"] = number(table.group_error.df);
    Json sphericity = Json::object();
    put_sphericity(sphericity, table.sphericity);
    return {{"group", group},
            {"method_type3", mixed_row(table.method_unweighted, table.method_unweighted_test)},
            {"method_type2_or_1", mixed_row(table.method_weighted, table.method_weighted_test)},
            {"group_x_method", mixed_row(table.group_x_method, table.group_x_method_test)},
            {"within_error", variation(table.within_error)},
            {"sphericity", sphericity}};
}

Json friedman(const consistency::RankTest& test) {
    Json row{{"b", test.blocks},
             {"k", test.conditions},
             {"rank_sums", test.rank_sums},
             {"chi2", number(test.chi_squared)},
             {"df", number(test.df)},
             {"p", number(test.p)},
             {"kendall_W", number(test.kendall_w)},
             {"iman_davenport_F", number(test.f)},
             {"p_F", number(test.p_f)}};
    put_reason(row, test.reason);
    return row;
}

Json nemenyi(const consistency::Nemenyi& test, const Names& names, double level) {
    Json pairs = Json::array();
    for (const auto& pair : test.pairs)
        pairs.push_back({{"a", names[pair.first]},
                         {"b", names[pair.second]},
                         {"mean_rank_diff", number(pair.mean_rank_difference)},
                         {"q", number(pair.q)},
                         {"p", number(pair.p)}});
    return {{"critical_difference_" + level_suffix(level), number(test.critical_difference)},
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
    tables["rm_method_tukey"] = range_test(findings.within_tukey, names);
    tables["rm_method_letters_" + level_suffix(level)] = letters(findings.within_letters, names);
    tables["paired_t"] = t_pairs(findings.paired_t, names);
    tables["rm_method_residuals"] = {{"fitted", findings.residuals.fitted},
                                     {"residual", findings.residuals.residual},
                                     {"shapiro_W", number(findings.residuals.normality.w)},
                                     {"shapiro_p", number(findings.residuals.normality.p)}};
    put_reason(tables["rm_method_residuals"], findings.residuals.normality.reason);
    const auto& parts = findings.components;
    tables["variance_components"] = {{"method", number(parts.condition)},
                                     {"observer_x_method", number(parts.observer_x_condition)},
                                     {"session_within_observer", number(parts.repetition)},
                                     {"inter_observer_sd", number(parts.inter_observer_sd)},
                                     {"intra_observer_sd", number(parts.intra_observer_sd)},
                                     {"reliability_of_means", number(parts.reliability)}};
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
