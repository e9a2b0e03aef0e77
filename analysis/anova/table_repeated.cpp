#include "analysis/anova/repeated.h"
#include "analysis/anova/table_design.h"
#include "analysis/anova/table_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace analysis::anova {

namespace {

using numerics::Shifted;

void repeated_levels(TableAnalysis& result,
                     const Measurements& table,
                     const SubjectCells& cells,
                     const Shifted& shifted,
                     Variation error,
                     std::optional<std::size_t> control) {
    const auto k = table.levels[0].size(), n = cells.subjects.size();
    std::vector<double> means, sd;
    for (std::size_t level = 0; level < k; ++level) {
        long double sum = 0, squares = 0;
        for (std::size_t o = 0; o < n; ++o)
            sum += cells.values[o * k + level];
        const long double mean = sum / static_cast<long double>(n);
        for (std::size_t o = 0; o < n; ++o) {
            const long double apart = cells.values[o * k + level] - mean;
            squares += apart * apart;
        }
        means.push_back(static_cast<double>(mean));
        sd.push_back(static_cast<double>(std::sqrt(squares / static_cast<long double>(n - 1))));
    }
    result.levels =
        compare_levels(table, result.options, means,
                       std::vector<std::int64_t>(k, static_cast<std::int64_t>(n)), error, control);
    result.levels->sd = std::move(sd);
    result.levels->t = paired_t(cells.values, k, result.options.level);
    to_data_unit(*result.levels, shifted);
}

// One factor is compared more fully elsewhere.
void compare_factors(TableAnalysis& result,
                     const Measurements& table,
                     const SubjectCells& cells,
                     const Shifted& shifted) {
    const double level = result.options.level;
    result.factors.resize(table.levels.size());
    const auto put = [&](MarginalMeans& means, std::size_t factor, bool within) {
        means.factor = factor;
        to_data_unit(means, shifted);
        result.factors[factor] = {table.names.factors[factor], {}, within, std::move(means)};
    };
    for (auto& means : marginal_means_within(cells.design, cells.values, level))
        put(means, cells.within[means.factor], true);
    for (auto& means : marginal_means_between(cells.design, cells.values, level))
        put(means, cells.between[means.factor], false);
    for (std::size_t f = 0; f < table.levels.size(); ++f)
        result.factors[f].levels = table.levels[f].names();
    for (std::size_t b = 0; b < cells.between.size(); ++b) {
        auto& names = result.factors[cells.between[b]].levels;
        names.clear();
        for (const auto kept : cells.between_levels[b])
            names.push_back(table.levels[cells.between[b]].name(kept));
    }
}

// y - m_cell - m_subject + m: within a group of subjects that share all between levels.
std::vector<double> repeated_residuals(const SubjectCells& cells) {
    const auto n = cells.subjects.size(), k = cells.values.size() / n;
    std::map<std::vector<std::size_t>, std::vector<std::size_t>> groups;
    for (std::size_t o = 0; o < n; ++o)
        groups[cells.design.groups[o]].push_back(o);
    std::vector<double> residuals;
    for (const auto& [levels, members] : groups) {
        const auto size = static_cast<long double>(members.size());
        std::vector<long double> cell_mean(k, 0);
        long double grand = 0;
        for (const auto o : members)
            for (std::size_t c = 0; c < k; ++c)
                cell_mean[c] += cells.values[o * k + c] / size;
        for (const auto mean : cell_mean)
            grand += mean / static_cast<long double>(k);
        for (const auto o : members) {
            long double subject = 0;
            for (std::size_t c = 0; c < k; ++c)
                subject += cells.values[o * k + c] / static_cast<long double>(k);
            for (std::size_t c = 0; c < k; ++c)
                residuals.push_back(
                    static_cast<double>(cells.values[o * k + c] - cell_mean[c] - subject + grand));
        }
    }
    return residuals;
}

std::string
why_not_repeated(const SubjectCells& cells, const Measurements& table, SumsOfSquares type) {
    const auto& design = cells.design;
    if (design.within.empty())
        return fmt::format("no factor varies within '{}': leave --within out, or name the column "
                           "of whoever was measured again",
                           table.names.subject);
    if (design.within.size() > 6)
        return "more than 6 factors within subjects";
    std::vector<std::vector<std::size_t>> groups = design.groups;
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    if (cells.subjects.size() < 2 || cells.subjects.size() <= groups.size())
        return fmt::format("{} of '{}' have a value in every combination of the factors within, "
                           "in {} groups: expected at least one more than groups, and two",
                           cells.subjects.size(), table.names.subject, groups.size());
    std::size_t combinations = 1;
    for (const auto& factor : design.between) {
        if (factor.levels < 2)
            return fmt::format("'{}' has one level left, expected two or more", factor.name);
        combinations *= factor.levels;
    }
    if (combinations != groups.size() && type == SumsOfSquares::Partial)
        return "some combination of the factors between subjects has nobody: type III sums of "
               "squares depend on the coding there; ask for type 1 or 2";
    return {};
}

} // namespace

Expected<TableAnalysis> repeated_analysis(TableAnalysis result,
                                          const Measurements& table,
                                          std::optional<std::size_t> control) {
    const auto shifted = numerics::about_first(table.response);
    const auto cells = subject_cells(table, shifted);
    if (auto why = why_not_repeated(cells, table, result.options.type); !why.empty())
        return tl::unexpected(std::move(why));
    if (!cells.left_out.empty())
        result.notes.push_back(fmt::format("Left out, because they lack a value in some "
                                           "combination of the factors within: {}.",
                                           fmt::join(cells.left_out, ", ")));
    if (cells.replicated)
        result.notes.push_back("Several values of one subject in one cell were averaged first.");
    const auto analysis = repeated(cells.design, cells.values, result.options.type);
    result.design = cells.design.between.empty() ? "within" : "mixed";
    result.values = static_cast<std::int64_t>(cells.values.size());
    result.subjects = static_cast<std::int64_t>(cells.subjects.size());
    long double sum = 0;
    for (const auto value : cells.values)
        sum += value / static_cast<long double>(cells.values.size());
    result.grand_mean = shifted.in_data_unit(sum, shifted.origin);
    for (const auto& effect : analysis.effects) {
        TableTerm term;
        term.name = effect.name;
        term.effect = effect.effect;
        term.error = effect.error;
        term.test = effect.test;
        term.eta_squared_partial = effect.eta_squared_partial;
        term.eta_squared_generalized = effect.eta_squared_generalized;
        term.sphericity = effect.sphericity;
        add_term(result, std::move(term));
    }
    result.residual = analysis.residual;
    result.total = analysis.total;
    finish_sums(result, shifted);
    if (table.levels.size() == 1)
        repeated_levels(result, table, cells, shifted, analysis.effects[0].error, control);
    else
        compare_factors(result, table, cells, shifted);
    result.normality = shapiro_wilk(repeated_residuals(cells));
    return result;
}

} // namespace analysis::anova
