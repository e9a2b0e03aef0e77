#include "analysis/scaling/scales.h"

#include "analysis/scaling/bradley_terry.h"
#include "analysis/scaling/thurstone.h"
#include "analysis/vote_matrix.h"
#include "protocols/contract.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace analysis::scaling {

namespace {

using Wins = std::vector<std::int64_t>;

Wins wins_of(const VoteMatrix& matrix) {
    const auto t = matrix.conditions();
    Wins wins(t * t, 0);
    for (std::size_t i = 0; i < t; ++i)
        for (std::size_t j = 0; j < t; ++j)
            if (i != j)
                wins[i * t + j] = matrix.wins(i, j);
    return wins;
}

// Matrices and the views that the fits read.
struct Parts {
    std::vector<std::string> names;
    std::vector<Wins> wins;

    std::vector<WinCounts> views(std::size_t conditions) const {
        std::vector<WinCounts> counts;
        for (const auto& matrix : wins)
            counts.push_back({conditions, matrix});
        return counts;
    }
};

Parts by_observer(const VoteTable& table) {
    Parts parts;
    for (const auto& scoped : count_votes(table, {true, false, {}})) {
        parts.names.push_back(scoped.observer);
        parts.wins.push_back(wins_of(scoped.matrix));
    }
    return parts;
}

std::string joined(const std::vector<std::string>& levels) {
    std::vector<std::string> kept;
    for (const auto& level : levels)
        if (!level.empty())
            kept.push_back(level);
    return fmt::format("{}", fmt::join(kept, "*"));
}

PartScales scales_of_parts(const VoteTable& table, std::string factor, const Scope& scope) {
    PartScales result;
    result.factor = std::move(factor);
    Parts parts;
    for (const auto& scoped : count_votes(table, scope)) {
        result.levels.push_back(joined(scoped.scene));
        parts.wins.push_back(wins_of(scoped.matrix));
    }
    const auto views = parts.views(table.conditions.size());
    for (const auto& part : views)
        result.fits.push_back(fit_bradley_terry(part));
    result.heterogeneity = heterogeneity_test(views, Link::Logit);
    return result;
}

std::vector<PartScales> parts_of(const VoteTable& table) {
    std::vector<PartScales> result;
    for (std::size_t f = 0; f < table.factors.size(); ++f) {
        if (table.factors[f].size() < 2)
            continue;
        Scope scope{false, false, std::vector<bool>(table.factors.size(), false)};
        scope.factors[f] = true;
        result.push_back(scales_of_parts(table, table.factor_names[f], scope));
    }
    if (result.size() > 1)
        result.push_back(scales_of_parts(
            table, "", {false, false, std::vector<bool>(table.factors.size(), true)}));
    return result;
}

void add_sides_and_ties(Scales& scales, const VoteMatrix& all) {
    const auto t = all.conditions();
    Wins tied(t * t, 0);
    scales.first_chosen.assign(t * t, 0);
    scales.second_chosen.assign(t * t, 0);
    for (std::size_t i = 0; i < t; ++i)
        for (std::size_t j = 0; j < t; ++j)
            if (i != j) {
                scales.first_chosen[i * t + j] = all.left_chosen(i, j);
                scales.second_chosen[i * t + j] = all.right_chosen(i, j);
                tied[i * t + j] = all.tied(i, j);
            }
    scales.side.fit = fit_bradley_terry_sides({t, scales.first_chosen, scales.second_chosen, {}});
    scales.side.test = likelihood_ratio_test(scales.bradley_terry, scales.side.fit, 1);
    if (all.total_ties() > 0)
        scales.davidson =
            fit_davidson({t, scales.first_chosen, scales.second_chosen, tied}, Sides::Ignored);
}

void add_observers(Scales& scales, const Parts& observers) {
    const auto views = observers.views(scales.bradley_terry.conditions());
    const auto& fit = scales.bradley_terry;
    scales.observers = observers.names;
    scales.robust_covariance =
        cluster_robust_covariance(fit, views, Link::Logit, SmallSample::AsIs);
    scales.robust_covariance_small =
        cluster_robust_covariance(fit, views, Link::Logit, SmallSample::Corrected);
    auto robust = fit;
    robust.covariance = scales.robust_covariance_small;
    scales.wald_robust = wald_pairs(robust);
    if (views.size() < 2)
        return;
    scales.left_out = leave_one_out(views, Link::Logit);
    BootstrapOptions options{.replicates = scales.options.replicates,
                             .seed = scales.options.seed,
                             .level = 1 - scales.options.level};
    if (scales.bradley_terry.estimate == Estimate::None)
        return;
    scales.odds = bootstrap(views, options);
    options.link = Link::Probit;
    scales.units = bootstrap(views, options);
}

} // namespace

Scales fit_scales(const VoteTable& table, const ScaleOptions& options) {
    EXPECTS(table.size() > 0 && table.conditions.size() > 0 && options.replicates > 0);
    Scales scales;
    scales.options = options;
    const auto all = count_votes(table);
    const auto wins = wins_of(all);
    const WinCounts counts{table.conditions.size(), wins};
    scales.bradley_terry = fit_bradley_terry(counts);
    scales.firth = fit_bradley_terry_firth(counts);
    scales.ridge = fit_bradley_terry_ridge(counts, 1);
    scales.thurstone = fit_thurstone(counts);
    scales.jod = in_unit(scales.thurstone, jod_sigma);
    scales.equality = equality_test(counts, scales.bradley_terry);
    scales.fit = goodness_of_fit(counts, scales.bradley_terry, Link::Logit);
    scales.wald = wald_pairs(scales.bradley_terry);
    const double confidence = 1 - options.level;
    scales.likelihood = likelihood_intervals(counts, scales.bradley_terry, Link::Logit, confidence);
    scales.likelihood_jod =
        likelihood_intervals(counts, scales.thurstone, Link::Probit, confidence);
    for (auto& [lower, upper] : scales.likelihood_jod) {
        lower *= jod_sigma;
        upper *= jod_sigma;
    }
    add_sides_and_ties(scales, all);
    scales.parts = parts_of(table);
    add_observers(scales, by_observer(table));
    return scales;
}

std::string existence_in_words(const Existence& found, const std::vector<std::string>& names) {
    std::vector<std::string> groups;
    for (const auto& component : found.components) {
        std::vector<std::string> members;
        for (const auto condition : component)
            members.push_back(names.at(condition));
        groups.push_back(fmt::format("{{{}}}", fmt::join(members, ", ")));
    }
    switch (found.scale) {
    case Scale::Finite:
        return "";
    case Scale::Separated:
        return fmt::format("no condition of a later group was ever chosen over one of an earlier "
                           "group in {}",
                           fmt::join(groups, " above "));
    case Scale::Disconnected:
        return fmt::format("no vote decides between these groups, neither directly nor through "
                           "others: {}",
                           fmt::join(groups, ", "));
    }
    return "";
}

} // namespace analysis::scaling
