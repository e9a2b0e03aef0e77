// Sums are formed of exact residues; cells carry them into the comparison of models.
#include "analysis/anova/checks.h"
#include "analysis/anova/table_design.h"
#include "analysis/anova/table_parts.h"
#include "analysis/numerics/one_way_exact.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace analysis::anova {

namespace {

using numerics::Shifted;

// Beyond, comparing models cell by cell takes minutes.
constexpr std::size_t most_cells = 600;
constexpr std::size_t most_factors = 6;

// One factor, independent values: exact sums, and the checks.
void one_way_extras(TableAnalysis& result,
                    const Measurements& table,
                    const std::vector<CellValues>& cells,
                    const Shifted& shifted,
                    std::optional<std::size_t> control) {
    const auto k = table.levels[0].size();
    std::vector<std::vector<numerics::Decimal>> exact(k);
    for (std::size_t row = 0; row < table.size(); ++row)
        exact[table.factor[0][row]].push_back(table.response[row]);
    std::vector<std::vector<double>> groups;
    for (const auto& cell : cells)
        groups.emplace_back(cell.values.begin(), cell.values.end());
    const auto one = one_way(groups);
    std::vector<double> sd;
    for (const double variance : one.variance)
        sd.push_back(std::sqrt(variance));
    auto& term = result.terms[0];
    if (result.residual.df > 0) {
        const auto sums = numerics::one_way_exact(exact);
        term.effect.ss = sums.ss_between;
        result.residual.ss = sums.ss_within;
        result.residual_sd = sums.residual_sd;
        result.total.ss = sums.ss_between + sums.ss_within;
        result.r_squared = sums.r_squared;
        if (term.test.outcome == Outcome::Computed) {
            term.test.f = sums.f;
            term.test.p = sums.p.p;
            term.test.log10_p = sums.p.log10_p;
        }
    }
    term.epsilon_squared = one.epsilon_squared;
    result.levels = compare_levels(table, result.options, one.mean, one.n, one.within, control);
    auto& levels = *result.levels;
    levels.sd = std::move(sd);
    levels.t = pooled_t(one, result.options.level);
    levels.games_howell = games_howell(one, result.options.level);
    levels.welch = welch(one);
    levels.levene = levene(groups);
    levels.brown_forsythe = brown_forsythe(groups);
    to_data_unit(levels, shifted);
}

std::string term_name(const Measurements& table, const std::vector<std::size_t>& factors) {
    std::string name;
    for (const auto f : factors)
        name += (name.empty() ? "" : ":") + table.names.factors[f];
    return name;
}

struct WithinCells {
    long double squares = 0;
    std::vector<double> residuals;
    long double sum = 0;
    long double largest = 0;
};

WithinCells within_cells(const std::vector<CellValues>& cells) {
    WithinCells within;
    for (const auto& cell : cells) {
        const long double mean = cell.mean();
        long double squares = 0, rest = 0;
        const bool constant = std::all_of(cell.values.begin(), cell.values.end(),
                                          [&](auto v) { return v == cell.values[0]; });
        for (const auto value : cell.values) {
            const long double apart = constant ? 0 : value - mean;
            squares += apart * apart;
            rest += apart;
            within.residuals.push_back(static_cast<double>(apart));
            within.sum += value;
            within.largest = std::max(within.largest, std::abs(value));
        }
        within.squares += squares - rest * rest / static_cast<long double>(cell.values.size());
    }
    return within;
}

std::string why_not_factorial(const Measurements& table,
                              const TableOptions& options,
                              const std::vector<CellValues>& cells) {
    if (table.levels.size() > most_factors)
        return fmt::format("{} factors, expected at most {}", table.levels.size(), most_factors);
    if (cells.size() > most_cells)
        return fmt::format("{} combinations of levels have values, expected at most {}",
                           cells.size(), most_cells);
    const auto empty = empty_cells(table, cells, 6);
    if (!empty.empty() && options.type == SumsOfSquares::Partial)
        return fmt::format(
            "no values for {}{}: type III sums of squares depend on the coding "
            "there; ask for type 1 or 2",
            fmt::join(empty.begin(),
                      empty.begin() +
                          std::min<std::ptrdiff_t>(5, static_cast<std::ptrdiff_t>(empty.size())),
                      ", "),
            empty.size() > 5 ? ", ..." : "");
    return {};
}

// Cells' means about the grand mean, which is in every model.
std::vector<long double> centred_means(const std::vector<CellValues>& cells, long double grand) {
    std::vector<long double> means;
    for (const auto& cell : cells)
        means.push_back(cell.mean() - grand);
    return means;
}

std::vector<Factor> factors_of(const Measurements& table) {
    std::vector<Factor> factors;
    for (std::size_t f = 0; f < table.levels.size(); ++f)
        factors.push_back({table.names.factors[f], table.levels[f].size()});
    return factors;
}

std::vector<Cell> counts_of(const std::vector<CellValues>& cells) {
    std::vector<Cell> counts;
    for (const auto& cell : cells)
        counts.push_back(cell.cell);
    return counts;
}

ModelComparison models_of(const Measurements& table, const std::vector<CellValues>& cells) {
    return {factors_of(table), counts_of(cells)};
}

// One factor is compared more fully elsewhere.
void compare_factors(TableAnalysis& result,
                     const Measurements& table,
                     const std::vector<CellValues>& cells,
                     const Shifted& shifted) {
    const auto factors = factors_of(table);
    std::vector<long double> means;
    for (const auto& cell : cells)
        means.push_back(cell.mean());
    for (auto& found :
         marginal_means(factors, counts_of(cells), means, result.residual, result.options.level)) {
        to_data_unit(found, shifted);
        result.factors.push_back({factors[found.factor].name, table.levels[found.factor].names(),
                                  false, std::move(found)});
    }
}

std::string note_on_balance(const ModelComparison& models, std::size_t factors) {
    if (!models.filled())
        return "Some combinations of levels have no values: an interaction there has fewer degrees "
               "of freedom.";
    if (!models.balanced() && factors > 1)
        return "Cells differ in size, so sums of squares depend on their type.";
    return {};
}

TableTerm term_of(std::string name, Variation effect, Variation residual, double values) {
    TableTerm term;
    term.name = std::move(name);
    term.effect = effect;
    term.test = f_test(effect, residual);
    if (effect.ss + residual.ss > 0 && residual.df > 0) {
        const double ms = residual.ms(), rest = values - effect.df;
        term.eta_squared_partial = effect.ss / (effect.ss + residual.ss);
        term.omega_squared_partial = (effect.ss - effect.df * ms) / (effect.ss + rest * ms);
    }
    return term;
}

} // namespace

Expected<TableAnalysis> independent_analysis(TableAnalysis result,
                                             const Measurements& table,
                                             std::optional<std::size_t> control) {
    const auto shifted = numerics::about_first(table.response);
    const auto cells = cells_of(table, shifted);
    if (auto why = why_not_factorial(table, result.options, cells); !why.empty())
        return tl::unexpected(std::move(why));
    const auto within = within_cells(cells);
    const auto n = static_cast<long double>(table.size());
    const auto values = static_cast<double>(n);
    const auto means = centred_means(cells, within.sum / n);
    const auto models = models_of(table, cells);
    if (auto note = note_on_balance(models, table.levels.size()); !note.empty())
        result.notes.push_back(std::move(note));
    result.design = table.levels.size() == 1 ? "one-way" : "factorial";
    result.values = static_cast<std::int64_t>(table.size());
    result.grand_mean = shifted.in_data_unit(within.sum / n, shifted.origin);
    result.residual = {static_cast<double>(within.squares),
                       values - static_cast<double>(cells.size())};
    // Sums of squares below what rounding leaves are none.
    const long double rounding = within.largest * n * std::numeric_limits<long double>::epsilon();
    const auto sums = models.squares(means, result.options.type);
    const auto terms = factorial_terms(table.levels.size());
    for (std::size_t k = 0; k < terms.size(); ++k) {
        const auto& sum = sums[k + 1]; // the mean is first
        const auto ss = sum.ss <= rounding * rounding ? 0 : static_cast<double>(sum.ss);
        add_term(result,
                 term_of(term_name(table, terms[k]), {ss, sum.df}, result.residual, values));
    }
    long double total = within.squares;
    for (std::size_t c = 0; c < cells.size(); ++c)
        total += static_cast<long double>(cells[c].values.size()) * means[c] * means[c];
    result.total = {static_cast<double>(total), values - 1};
    if (table.levels.size() > 1)
        compare_factors(result, table, cells, shifted);
    finish_sums(result, shifted);
    if (table.levels.size() == 1)
        one_way_extras(result, table, cells, shifted, control);
    result.normality = shapiro_wilk(within.residuals);
    return result;
}

} // namespace analysis::anova
