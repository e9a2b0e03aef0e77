// What the two kinds of table analysis share.
#pragma once

#include "analysis/anova/table_analysis.h"
#include "analysis/numerics/shifted.h"

#include <optional>
#include <vector>

namespace analysis::anova {

/// Appends the term with the interval of its effect size.
void add_term(TableAnalysis& result, TableTerm term);

/// Shares of the total and the residual deviation; then every sum of squares goes from the unit of
/// the residues to that of the data, where squares may leave the range of a double.
void finish_sums(TableAnalysis& result, const numerics::Shifted& shifted);

/// Means and everything that compares them, in the unit of the residues.
LevelComparisons compare_levels(const Measurements& table,
                                const TableOptions& options,
                                std::vector<double> means,
                                std::vector<std::int64_t> n,
                                Variation error,
                                std::optional<std::size_t> control);

/// The same for levels.
void to_data_unit(LevelComparisons& levels, const numerics::Shifted& shifted);
void to_data_unit(MarginalMeans& means, const numerics::Shifted& shifted);

/// Every value independent of the others.
Expected<TableAnalysis> independent_analysis(TableAnalysis result,
                                             const Measurements& table,
                                             std::optional<std::size_t> control);

/// Subjects measured again and again.
Expected<TableAnalysis> repeated_analysis(TableAnalysis result,
                                          const Measurements& table,
                                          std::optional<std::size_t> control);

} // namespace analysis::anova
