// Sums of squares of unbalanced designs, by comparing models with and without a term.
// [Speed1978] for the three types; sum-to-zero coding throughout.
#pragma once

#include "analysis/anova/within_observers.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace analysis::anova {

/// Types I, II and III.
enum class SumsOfSquares {
    Sequential,   ///< each term after those before it
    Hierarchical, ///< each term after all that do not contain it
    Partial       ///< each term after all others
};

/// A combination of levels that has values: one level per factor, and how many values.
struct Cell {
    std::vector<std::size_t> levels;
    std::size_t count = 0;
};

/// The terms of a full factorial: by number of factors, then in the order of factors.
std::vector<std::vector<std::size_t>> factorial_terms(std::size_t factors);

/// A term's sum of squares, and its degrees of freedom: the rank it adds.
struct TermSquares {
    long double ss = 0;
    double df = 0;
};

/// Full factorial models of cell means; a model is an orthogonal basis of its columns, and a sum of
/// squares is the length of what falls on the columns a term adds.  Nothing is subtracted.
class ModelComparison {
  public:
    /// Errors: EXPECTS cells with a level for each factor and a count above 0.  No factors: one
    /// cell, and the mean is the only term.
    ModelComparison(std::vector<Factor> factors, std::vector<Cell> cells);

    /// Whether every combination of levels has values.
    bool filled() const;
    /// Whether every cell has the same number of values: then all types agree.
    bool balanced() const;

    /// The mean first, then every term of `factorial_terms`.  The mean is tested against 0: first
    /// of all for types I and II, last for type III (equal weight to every cell).
    /// EXPECTS one mean per cell; for type III EXPECTS filled().
    std::vector<TermSquares> squares(std::span<const long double> cell_means,
                                     SumsOfSquares type) const;

  private:
    using Columns = std::vector<std::vector<long double>>;

    Columns columns(const std::vector<std::size_t>& term) const;
    std::vector<std::size_t> terms_before(std::size_t term, SumsOfSquares type) const;

    std::vector<Factor> factors_;
    std::vector<Cell> cells_;
    std::vector<std::vector<std::size_t>> terms_; ///< the mean is the empty one
};

} // namespace analysis::anova
