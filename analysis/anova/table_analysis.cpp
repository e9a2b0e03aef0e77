#include "analysis/anova/table_analysis.h"

#include "analysis/anova/letters.h"
#include "analysis/anova/number_range.h"
#include "analysis/anova/table_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace analysis::anova {

namespace {

Expected<std::optional<std::size_t>> control_of(const Measurements& table,
                                                const TableOptions& options) {
    if (options.control.empty())
        return std::optional<std::size_t>{};
    if (table.levels.size() != 1)
        return tl::unexpected(std::string("a control goes with a single factor"));
    const auto found = table.levels[0].find(options.control);
    if (found < 0)
        return tl::unexpected(fmt::format("control '{}' is no level of {}, expected one of {}",
                                          options.control, table.names.factors[0],
                                          fmt::join(table.levels[0].names(), ", ")));
    return std::optional(static_cast<std::size_t>(found));
}

} // namespace

void finish_sums(TableAnalysis& result, const numerics::Shifted& shifted) {
    const auto scale = [&](Variation& part) {
        part.ss = shifted.squares_in_data_unit(static_cast<long double>(part.ss));
    };
    if (result.total.ss > 0) {
        for (auto& term : result.terms)
            term.eta_squared = term.effect.ss / result.total.ss;
        result.r_squared = 1 - result.residual.ss / result.total.ss;
    }
    if (result.residual.df > 0)
        result.residual_sd =
            shifted.in_data_unit(std::sqrt(static_cast<long double>(result.residual.ms())), 0);
    for (auto& term : result.terms) {
        scale(term.effect);
        if (term.error)
            scale(*term.error);
    }
    scale(result.residual);
    scale(result.total);
}

LevelComparisons compare_levels(const Measurements& table,
                                const TableOptions& options,
                                std::vector<double> means,
                                std::vector<std::int64_t> n,
                                Variation error,
                                std::optional<std::size_t> control) {
    LevelComparisons levels;
    levels.levels = table.levels[0].names();
    levels.tukey = tukey(means, n, error, options.level);
    levels.letters = letters_by_means(means, differing(levels.tukey.pairs));
    if (control)
        levels.dunnett = dunnett(means, n, error, *control, options.level);
    levels.mean = std::move(means);
    levels.n = std::move(n);
    return levels;
}

namespace {

// Differences and what is measured in their unit.
class Unit {
  public:
    explicit Unit(const numerics::Shifted& shifted) : shifted_(shifted) {}

    void difference(double& value) const {
        value = shifted_.in_data_unit(static_cast<long double>(value), 0);
    }

    void mean(double& value) const {
        value = shifted_.in_data_unit(static_cast<long double>(value), shifted_.origin);
    }

    void put(RangeTest& test) const {
        auto& mse = test.mean_square_error;
        mse = shifted_.squares_in_data_unit(static_cast<long double>(mse));
        difference(test.comparison_half_width);
        put(test.pairs);
    }

    void put(std::vector<RangePair>& pairs) const {
        for (auto& pair : pairs)
            for (auto* value : {&pair.difference, &pair.standard_error, &pair.lower, &pair.upper})
                difference(*value);
    }

    void put(std::vector<TPair>& pairs) const {
        for (auto& pair : pairs)
            for (auto* value : {&pair.difference, &pair.standard_error})
                difference(*value);
    }

  private:
    const numerics::Shifted& shifted_;
};

} // namespace

void to_data_unit(LevelComparisons& levels, const numerics::Shifted& shifted) {
    const Unit unit(shifted);
    for (auto& mean : levels.mean)
        unit.mean(mean);
    for (auto& sd : levels.sd)
        unit.difference(sd);
    unit.put(levels.tukey);
    unit.put(levels.games_howell);
    unit.put(levels.t);
    if (levels.dunnett)
        for (auto& pair : levels.dunnett->pairs)
            for (auto* value : {&pair.difference, &pair.lower, &pair.upper})
                unit.difference(*value);
}

void to_data_unit(MarginalMeans& means, const numerics::Shifted& shifted) {
    const Unit unit(shifted);
    for (auto& mean : means.mean)
        unit.mean(mean);
    if (means.tukey)
        unit.put(*means.tukey);
    unit.put(means.t);
}

void add_term(TableAnalysis& result, TableTerm term) {
    if (term.test.outcome == Outcome::Computed)
        term.eta_interval = eta_squared_interval(term.test.f, term.test.df1, term.test.df2,
                                                 1 - result.options.level);
    else
        term.eta_interval = {undefined, undefined};
    result.terms.push_back(std::move(term));
}

Expected<TableAnalysis> analyze_table(const Measurements& table, const TableOptions& options) {
    if (table.levels.empty())
        return tl::unexpected(std::string("no factor is named, expected at least one"));
    for (std::size_t f = 0; f < table.levels.size(); ++f)
        if (table.levels[f].size() < 2)
            return tl::unexpected(fmt::format("'{}' has one level, {}; expected two or more",
                                              table.names.factors[f], table.levels[f].name(0)));
    auto control = control_of(table, options);
    if (!control)
        return tl::unexpected(control.error());
    TableAnalysis result;
    result.columns = table.names;
    result.options = options;
    result.unit_exponent = unit_exponent(table);
    if (table.without_response > 0)
        result.notes.push_back(
            fmt::format("{} rows without a value were passed over.", table.without_response));
    const auto analyzed = [&](const Measurements& values) {
        return values.subject.empty() ? independent_analysis(std::move(result), values, *control)
                                      : repeated_analysis(std::move(result), values, *control);
    };
    const int exponent = result.unit_exponent;
    if (exponent == 0)
        return analyzed(table);
    result.notes.push_back(note_on_unit(table.names.response, exponent));
    return analyzed(in_unit(table, exponent));
}

} // namespace analysis::anova
