// What is undefined is null, with its reason beside it.
#include "analysis/anova/rows_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace analysis::anova {

Json json_number(double value) {
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

Json variation_json(const Variation& part) {
    return {{"SS", json_number(part.ss)},
            {"df", json_number(part.df)},
            {"MS", part.df > 0 ? json_number(part.ms()) : Json()}};
}

void put_test(Json& row, const FTest& test) {
    row["F"] = json_number(test.f);
    row["p"] = json_number(test.p);
    if (test.p < 1e-300)
        row["log10_p"] = json_number(test.log10_p);
    put_reason(row, test.reason);
}

Json test_json(const FTest& test) {
    Json row{{"F", json_number(test.f)},
             {"df1", json_number(test.df1)},
             {"df2", json_number(test.df2)},
             {"p", json_number(test.p)}};
    put_reason(row, test.reason);
    return row;
}

void put_error(Json& row, const Variation& error) {
    row["SS_error"] = json_number(error.ss);
    row["df_error"] = json_number(error.df);
    row["MS_error"] = json_number(error.ms());
}

void put_eta_interval(Json& row, const EtaInterval& interval, double level) {
    if (!std::isnan(interval.lower))
        row["eta2_partial_interval"] = {{"level", 1 - level},
                                        {"lower", json_number(interval.lower)},
                                        {"upper", json_number(interval.upper)}};
}

void put_sphericity(Json& row, const Sphericity& s) {
    if (std::isnan(s.greenhouse_geisser)) {
        if (!s.reason.empty())
            row["sphericity_reason"] = s.reason;
        return;
    }
    row["mauchly_W"] = json_number(s.mauchly_w);
    if (std::isnan(s.mauchly_w)) {
        row["mauchly_reason"] = s.reason;
    } else {
        row["mauchly_chi2"] = json_number(s.chi_squared);
        row["mauchly_df"] = json_number(s.df);
        row["mauchly_p_chi2"] = json_number(s.p_chi_squared);
        row["mauchly_p_box2"] = json_number(s.p_second_order);
        row["mauchly_p_as_R"] = json_number(s.p_as_r);
    }
    row["GG"] = json_number(s.greenhouse_geisser);
    row["HF_raw"] = json_number(s.huynh_feldt_raw);
    row["HF"] = json_number(s.huynh_feldt);
    row["p_GG"] = json_number(s.p_greenhouse_geisser);
    row["p_HF"] = json_number(s.p_huynh_feldt);
    row["p_lower_bound"] = json_number(s.p_lower_bound);
}

Json range_pairs_json(const std::vector<RangePair>& pairs, const std::vector<std::string>& names) {
    Json rows = Json::array();
    for (const auto& pair : pairs) {
        Json row{{"a", names[pair.first]},
                 {"b", names[pair.second]},
                 {"diff", json_number(pair.difference)},
                 {"se_q", json_number(pair.standard_error)},
                 {"df", json_number(pair.df)},
                 {"q", json_number(pair.q)}};
        if (!std::isnan(pair.lower)) { // not every such test has simultaneous intervals
            row["lower"] = json_number(pair.lower);
            row["upper"] = json_number(pair.upper);
        }
        row["p"] = json_number(pair.p);
        if (pair.p < 1e-300)
            row["log10_p"] = json_number(pair.log10_p);
        row["significant"] = pair.significant;
        rows.push_back(row);
    }
    return rows;
}

Json t_pairs_json(const std::vector<TPair>& pairs, const std::vector<std::string>& names) {
    Json rows = Json::array();
    for (const auto& pair : pairs)
        rows.push_back({{"a", names[pair.first]},
                        {"b", names[pair.second]},
                        {"mean_diff", json_number(pair.difference)},
                        {"se", json_number(pair.standard_error)},
                        {"t", json_number(pair.t)},
                        {"df", json_number(pair.df)},
                        {"p_raw", json_number(pair.p)},
                        {"p_bonferroni", json_number(pair.p_bonferroni)},
                        {"p_holm", json_number(pair.p_holm)},
                        {"p_hochberg", json_number(pair.p_hochberg)},
                        {"p_bh", json_number(pair.p_benjamini_hochberg)}});
    return rows;
}

Json range_test_json(const RangeTest& test, const std::vector<std::string>& names) {
    return {{"level", test.level},
            {"q_crit", json_number(test.q_critical)},
            {"k", test.groups},
            {"df", json_number(test.df)},
            {"MSE", json_number(test.mean_square_error)},
            {"pairs", range_pairs_json(test.pairs, names)}};
}

} // namespace analysis::anova
