// Rows are cells, weighted by the root of their counts.  Columns are made orthogonal one after the
// other, each twice, which leaves them as orthogonal as Householder's reflections would.
#include "analysis/anova/model_comparison.h"

#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace analysis::anova {

namespace {

using Real = long double;
using Column = std::vector<Real>;

Real dot(const Column& a, const Column& b) {
    Real sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
    return sum;
}

void subtract(Column& from, Real times, const Column& what) {
    for (std::size_t i = 0; i < from.size(); ++i)
        from[i] -= times * what[i];
}

// An orthonormal basis that grows by columns.
class Basis {
  public:
    // False when the column depends on those before it.
    bool add(Column column) {
        const Real length = std::sqrt(dot(column, column));
        if (length == 0)
            return false;
        for (int twice = 0; twice < 2; ++twice)
            for (const auto& direction : directions_)
                subtract(column, dot(direction, column), direction);
        const Real left = std::sqrt(dot(column, column));
        const auto larger = std::max(column.size(), directions_.size() + 1);
        if (left <= static_cast<Real>(larger) * std::numeric_limits<double>::epsilon() * length)
            return false;
        for (auto& value : column)
            value /= left;
        directions_.push_back(std::move(column));
        return true;
    }

    std::size_t size() const { return directions_.size(); }

    // Squared length of what of `values` falls on the directions from `first` on.
    Real squares_from(std::size_t first, Column values) const {
        Real squares = 0;
        for (std::size_t k = 0; k < directions_.size(); ++k) {
            const Real along = dot(directions_[k], values);
            subtract(values, along, directions_[k]);
            squares += k >= first ? along * along : 0;
        }
        return squares;
    }

  private:
    std::vector<Column> directions_;
};

// Sum-to-zero coding: the last level is minus all others.
Real code(std::size_t level, std::size_t levels, std::size_t column) {
    if (level + 1 == levels)
        return -1;
    return level == column ? 1 : 0;
}

bool contains(const std::vector<std::size_t>& larger, const std::vector<std::size_t>& smaller) {
    return std::includes(larger.begin(), larger.end(), smaller.begin(), smaller.end());
}

} // namespace

std::vector<std::vector<std::size_t>> factorial_terms(std::size_t factors) {
    std::vector<std::vector<std::size_t>> terms;
    for (unsigned set = 1; set < 1U << factors; ++set) {
        auto& term = terms.emplace_back();
        for (std::size_t f = 0; f < factors; ++f)
            if ((set >> f & 1U) != 0)
                term.push_back(f);
    }
    std::sort(terms.begin(), terms.end(), [](const auto& a, const auto& b) {
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    });
    return terms;
}

ModelComparison::ModelComparison(std::vector<Factor> factors, std::vector<Cell> cells)
    : factors_(std::move(factors)), cells_(std::move(cells)), terms_{{}} {
    EXPECTS(!cells_.empty());
    for (const auto& cell : cells_)
        EXPECTS(cell.count > 0 && cell.levels.size() == factors_.size());
    for (auto& term : factorial_terms(factors_.size()))
        terms_.push_back(std::move(term));
}

bool ModelComparison::filled() const {
    std::size_t combinations = 1;
    for (const auto& factor : factors_)
        combinations *= factor.levels;
    return cells_.size() == combinations;
}

bool ModelComparison::balanced() const {
    return filled() && std::all_of(cells_.begin(), cells_.end(),
                                   [&](const Cell& cell) { return cell.count == cells_[0].count; });
}

ModelComparison::Columns ModelComparison::columns(const std::vector<std::size_t>& term) const {
    Columns result{Column(cells_.size())};
    for (std::size_t c = 0; c < cells_.size(); ++c)
        result[0][c] = std::sqrt(static_cast<Real>(cells_[c].count));
    for (const auto f : term) {
        Columns products;
        for (const auto& column : result)
            for (std::size_t k = 0; k + 1 < factors_[f].levels; ++k) {
                products.push_back(column);
                for (std::size_t c = 0; c < cells_.size(); ++c)
                    products.back()[c] *= code(cells_[c].levels[f], factors_[f].levels, k);
            }
        result = std::move(products);
    }
    return result;
}

std::vector<std::size_t> ModelComparison::terms_before(std::size_t term, SumsOfSquares type) const {
    std::vector<std::size_t> before;
    for (std::size_t other = 0; other < terms_.size(); ++other) {
        if (other == term)
            continue;
        const bool sequential = type == SumsOfSquares::Sequential && other < term;
        const bool hierarchical =
            type == SumsOfSquares::Hierarchical && !contains(terms_[other], terms_[term]);
        if (sequential || hierarchical || type == SumsOfSquares::Partial)
            before.push_back(other);
    }
    return before;
}

std::vector<TermSquares> ModelComparison::squares(std::span<const long double> cell_means,
                                                  SumsOfSquares type) const {
    EXPECTS(cell_means.size() == cells_.size());
    EXPECTS(type != SumsOfSquares::Partial || filled());
    if (balanced())
        type = SumsOfSquares::Sequential; // the same numbers from one basis
    Column values;
    for (std::size_t c = 0; c < cells_.size(); ++c)
        values.push_back(cell_means[c] * std::sqrt(static_cast<Real>(cells_[c].count)));
    std::vector<TermSquares> result;
    Basis basis;
    for (std::size_t term = 0; term < terms_.size(); ++term) {
        if (type != SumsOfSquares::Sequential) {
            basis = {};
            for (const auto before : terms_before(term, type))
                for (auto& column : columns(terms_[before]))
                    basis.add(std::move(column));
        }
        const auto first = basis.size();
        for (auto& column : columns(terms_[term]))
            basis.add(std::move(column));
        result.push_back(
            {basis.squares_from(first, values), static_cast<double>(basis.size() - first)});
    }
    return result;
}

} // namespace analysis::anova
