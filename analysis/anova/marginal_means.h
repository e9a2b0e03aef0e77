// Means of one factor's levels over those of all others, and all pairs of them.  [Searle1980]
#pragma once

#include "analysis/anova/comparisons.h"
#include "analysis/anova/model_comparison.h"
#include "analysis/anova/repeated.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace analysis::anova {

struct MarginalMeans {
    std::size_t factor = 0;           ///< of the design
    std::vector<double> mean;         ///< every combination of the other factors weighs the same
    std::optional<RangeTest> tukey;   ///< independent values, or between subjects
    std::vector<TPair> t;             ///< beside it; within subjects each pair with its own error
    std::vector<std::string> letters; ///< by Tukey, within subjects by Holm; empty when too many
    std::string reason;               ///< why there is nothing of this
};

/// More levels than anybody compares in pairs: 19,900 of them.
inline constexpr std::size_t most_levels_in_pairs = 200;

/// For each factor of independent values.  Tukey-Kramer on cell means: the standard error of a
/// difference is that of the unweighted means, and equal where the design is balanced.
/// A design with an empty cell has no such means, and `reason` says so.
std::vector<MarginalMeans> marginal_means(const std::vector<Factor>& factors,
                                          std::span<const Cell> cells,
                                          std::span<const long double> cell_means,
                                          Variation error,
                                          double level);

/// For each factor within subjects: paired t of subjects' means, groups of the between design
/// weighing the same; the error of a pair is its own spread within groups, so no sphericity is
/// assumed.
std::vector<MarginalMeans> marginal_means_within(const RepeatedDesign& design,
                                                 std::span<const long double> values,
                                                 double level);

/// For each factor between subjects, on subjects' means.
std::vector<MarginalMeans> marginal_means_between(const RepeatedDesign& design,
                                                  std::span<const long double> values,
                                                  double level);

} // namespace analysis::anova
