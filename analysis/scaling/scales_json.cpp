#include "analysis/scaling/scales_json.h"

#include "analysis/scaling/bradley_terry.h"
#include "analysis/scaling/thurstone.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace analysis::scaling {

namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

// NaN becomes null in the text.
Json square(const std::vector<double>& matrix, std::size_t t) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < t; ++i)
        rows.push_back(
            std::vector<double>(matrix.begin() + static_cast<std::ptrdiff_t>(i * t),
                                matrix.begin() + static_cast<std::ptrdiff_t>(i * t + t)));
    return rows;
}

Json roots_of_diagonal(const std::vector<double>& matrix, std::size_t t) {
    Json roots = Json::array();
    for (std::size_t i = 0; i < t; ++i)
        roots.push_back(std::sqrt(matrix[i * t + i]));
    return roots;
}

const char* estimate_word(Estimate estimate) {
    switch (estimate) {
    case Estimate::MaximumLikelihood:
        return "maximum likelihood";
    case Estimate::Firth:
        return "Firth";
    case Estimate::Ridge:
        return "ridge";
    case Estimate::None:
        return "none";
    }
    return "";
}

Json fit_json(const ChoiceFit& fit, const Names& names) {
    const auto t = fit.conditions();
    std::vector<double> from_first;
    for (const double theta : fit.theta)
        from_first.push_back(theta - fit.theta[0]);
    Json row{{"estimate", estimate_word(fit.estimate)},
             {"theta_centered", fit.theta},
             {"loglik", fit.log_likelihood},
             {"se_centered", roots_of_diagonal(fit.covariance, t)},
             {"cov_centered", square(fit.covariance, t)},
             {"theta_minus_first", from_first},
             {"newton_iterations", fit.iterations}};
    if (!fit.reason.empty())
        row["reason"] = fit.reason;
    if (const auto words = existence_in_words(fit.existence, names); !words.empty())
        row["existence"] = words;
    return row;
}

Json wald(const std::vector<WaldPair>& pairs, const Names& names) {
    Json rows = Json::array();
    for (const auto& pair : pairs)
        rows.push_back({{"a", names[pair.a]},
                        {"b", names[pair.b]},
                        {"diff", pair.difference},
                        {"se", pair.standard_error},
                        {"z", pair.z},
                        {"p", pair.p.p}});
    return rows;
}

Json likelihood(const std::vector<LikelihoodInterval>& intervals, double level) {
    Json lower = Json::array(), upper = Json::array();
    for (const auto& interval : intervals) {
        lower.push_back(interval.lower);
        upper.push_back(interval.upper);
    }
    return {{"level", level}, {"lower", lower}, {"upper", upper}};
}

Json bradley_terry(const Scales& scales, const Names& names) {
    const auto& fit = scales.bradley_terry;
    auto row = fit_json(fit, names);
    double votes = 0;
    for (std::size_t k = 0; k < scales.first_chosen.size(); ++k)
        votes += static_cast<double>(scales.first_chosen[k] + scales.second_chosen[k]);
    row["worths"] = worths(fit);
    row["loglik_null_equal"] = -votes * std::numbers::ln2;
    row["LRT_equal_chi2"] = scales.equality.chi_squared;
    row["LRT_equal_df"] = scales.equality.df;
    row["LRT_equal_p"] = scales.equality.p.p;
    row["loglik_saturated"] = fit.log_likelihood + scales.fit.g2.chi_squared / 2;
    row["fit_G2"] = scales.fit.g2.chi_squared;
    row["fit_df"] = scales.fit.g2.df;
    row["fit_G2_p"] = scales.fit.g2.p.p;
    row["fit_X2"] = scales.fit.x2.chi_squared;
    row["fit_X2_p"] = scales.fit.x2.p.p;
    row["wald_pairs"] = wald(scales.wald, names);
    row["likelihood_interval"] = likelihood(scales.likelihood, 1 - scales.options.level);
    return row;
}

Json side_effect(const Scales& scales, const Names& names) {
    const auto t = names.size();
    auto row = fit_json(scales.side.fit, names);
    const auto& side = scales.side.fit.side;
    row["side"] = side ? Json(side->value) : Json();
    row["side_se"] = side ? Json(side->standard_error) : Json();
    row["LRT_side_chi2"] = scales.side.test.chi_squared;
    row["LRT_side_p"] = scales.side.test.p.p;
    row["wald_z"] = side ? Json(side->value / side->standard_error) : Json();
    Json counts = Json::array();
    for (std::size_t i = 0; i < t; ++i)
        for (std::size_t j = 0; j < t; ++j) {
            const auto first = scales.first_chosen[i * t + j];
            const auto second = scales.second_chosen[i * t + j];
            if (first + second > 0)
                counts.push_back({i, j, first, second});
        }
    row["left_right_counts"] = counts;
    return row;
}

Json davidson(const ChoiceFit& fit, const Names& names) {
    auto row = fit_json(fit, names);
    row["log_nu"] = fit.log_nu ? Json(fit.log_nu->value) : Json();
    row["log_nu_se"] = fit.log_nu ? Json(fit.log_nu->standard_error) : Json();
    return row;
}

Json test_json(const ChiSquaredTest& test) {
    Json row{{"chi2", test.chi_squared}, {"df", test.df}, {"p", test.p.p}};
    if (std::isnan(test.chi_squared))
        row["reason"] = "some part has no finite scale of its own";
    return row;
}

void put_parts(Json& models, const Scales& scales, const Names& names) {
    for (const auto& part : scales.parts) {
        if (!part.factor.empty()) {
            for (std::size_t level = 0; level < part.levels.size(); ++level)
                models["bradley_terry_" + part.factor + "_" + part.levels[level]] =
                    fit_json(part.fits[level], names);
            models["heterogeneity_" + part.factor + "s"] = test_json(part.heterogeneity);
            continue;
        }
        Json rows = Json::array();
        for (std::size_t level = 0; level < part.levels.size(); ++level) {
            auto row = fit_json(part.fits[level], names);
            row["scene"] = part.levels[level];
            rows.push_back(row);
        }
        models["bradley_terry_whole_scenes"] = rows;
        models["heterogeneity_whole_scenes"] = test_json(part.heterogeneity);
    }
}

Json left_out(const Scales& scales) {
    Json rows = Json::array();
    for (std::size_t o = 0; o < scales.left_out.size(); ++o) {
        const auto& left = scales.left_out[o];
        rows.push_back({{"observer", scales.observers[o]},
                        {"loo_loglik", left.log_likelihood},
                        {"loo_loglik_per_vote", left.log_likelihood_per_vote},
                        {"expected_loglik", left.expected},
                        {"z", left.z},
                        {"theta_ridge_0_1", left.own_theta},
                        {"theta_of_the_others", left.others.theta}});
    }
    return rows;
}

Json intervals(const std::vector<Interval>& found, double unit) {
    Json rows = Json::array();
    for (const auto& interval : found) {
        Json row{{"lower", unit * interval.lower},
                 {"upper", unit * interval.upper},
                 {"lower_monte_carlo_se", unit * interval.lower_error},
                 {"upper_monte_carlo_se", unit * interval.upper_error}};
        if (interval.clamped)
            row["clamped"] = true;
        if (interval.constant)
            row["constant"] = true;
        rows.push_back(row);
    }
    return rows;
}

Json bootstrap_json(const Bootstrap& found, double unit) {
    const auto t = found.fit.conditions();
    auto scaled = [&](std::vector<double> values) {
        for (auto& value : values)
            value *= unit;
        return values;
    };
    return {{"B", found.options.replicates},
            {"seed", found.options.seed},
            {"resampled", "observers"},
            {"level", found.options.level},
            {"penalised_replicates", found.penalised},
            {"disconnected_replicates", found.disconnected},
            {"mean", scaled(found.mean)},
            {"se", scaled(found.standard_error)},
            {"percentile", intervals(found.percentile, unit)},
            {"bca", intervals(found.bca, unit)},
            {"share_first", found.first},
            {"share_row_above_column", square(found.above, t)}};
}

} // namespace

std::string scales_json(const Scales& scales, const Names& conditions) {
    const auto t = conditions.size();
    Json models;
    models["bradley_terry"] = bradley_terry(scales, conditions);
    models["bradley_terry_cluster_robust"] = {
        {"se_centered", roots_of_diagonal(scales.robust_covariance, t)},
        {"se_centered_corrected", roots_of_diagonal(scales.robust_covariance_small, t)},
        {"cov_centered", square(scales.robust_covariance, t)},
        {"wald_pairs", wald(scales.wald_robust, conditions)}};
    models["bradley_terry_firth"] = fit_json(scales.firth, conditions);
    models["bradley_terry_ridge_1"] = fit_json(scales.ridge, conditions);
    models["thurstone_V_unit_sigma_difference"] = fit_json(scales.thurstone, conditions);
    auto jod = fit_json(scales.jod, conditions);
    jod["sigma"] = jod_sigma;
    jod["likelihood_interval"] = likelihood(scales.likelihood_jod, 1 - scales.options.level);
    models["thurstone_V_JOD"] = jod;
    models["thurstone_V_JOD_sigma_1.4826"] =
        fit_json(in_unit(scales.thurstone, 1.4826), conditions); // as pwcmp rounds it
    models["bradley_terry_side"] = side_effect(scales, conditions);
    if (scales.davidson)
        models["davidson"] = davidson(*scales.davidson, conditions);
    put_parts(models, scales, conditions);
    models["leave_one_observer_out"] = left_out(scales);
    if (scales.odds)
        models["bootstrap_bradley_terry"] = bootstrap_json(*scales.odds, 1);
    if (scales.units)
        models["bootstrap_thurstone_V_JOD"] = bootstrap_json(*scales.units, jod_sigma);
    return models.dump();
}

} // namespace analysis::scaling
