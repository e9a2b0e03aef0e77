// Sums in long double: what cancels between groups leaves a double its digits.
#include "analysis/anova/marginal_means.h"

#include "analysis/anova/box.h"
#include "analysis/anova/letters.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace analysis::anova {

namespace {

using Real = long double;

/// A sum of squares, or none where it is what rounding leaves of `n` equal values, the largest of
/// which is `largest`.
Real without_rounding(Real squares, Real largest, std::size_t n) {
    const Real rounding = largest * static_cast<Real>(n) * std::numeric_limits<Real>::epsilon();
    return squares <= rounding * rounding ? 0 : squares;
}

std::string why_no_pairs(std::size_t levels) {
    return levels > most_levels_in_pairs
               ? "more than " + std::to_string(most_levels_in_pairs) + " levels"
               : "";
}

// Combinations of the levels of all factors but one.
std::size_t combinations_without(const std::vector<Factor>& factors, std::size_t left_out) {
    std::size_t product = 1;
    for (std::size_t f = 0; f < factors.size(); ++f)
        product *= f == left_out ? 1 : factors[f].levels;
    return product;
}

MarginalMeans means_of_factor(const std::vector<Factor>& factors,
                              std::size_t f,
                              std::span<const Cell> cells,
                              std::span<const Real> cell_means,
                              Variation error,
                              double level) {
    MarginalMeans found;
    found.factor = f;
    found.reason = why_no_pairs(factors[f].levels);
    if (!found.reason.empty())
        return found;
    const auto others = static_cast<Real>(combinations_without(factors, f));
    std::vector<Real> sums(factors[f].levels, 0), variances(factors[f].levels, 0);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        sums[cells[c].levels[f]] += cell_means[c];
        variances[cells[c].levels[f]] += 1 / static_cast<Real>(cells[c].count);
    }
    std::vector<double> sizes; // of a group whose mean would be known as well
    for (std::size_t i = 0; i < sums.size(); ++i) {
        found.mean.push_back(static_cast<double>(sums[i] / others));
        sizes.push_back(static_cast<double>(others * others / variances[i]));
    }
    found.tukey = tukey(found.mean, sizes, error, level);
    found.t = pooled_t(found.mean, sizes, error, level);
    found.letters = letters_by_means(found.mean, differing(found.tukey->pairs));
    return found;
}

// Subjects by group of the between design, in the order of its levels.
std::map<std::vector<std::size_t>, std::vector<std::size_t>>
members_of_groups(const RepeatedDesign& design) {
    std::map<std::vector<std::size_t>, std::vector<std::size_t>> groups;
    for (std::size_t o = 0; o < design.groups.size(); ++o)
        groups[design.groups[o]].push_back(o);
    return groups;
}

bool somebody_in_every_group(const RepeatedDesign& design, std::size_t groups) {
    return combinations_without(design.between, design.between.size()) == groups;
}

constexpr const char* nobody = "some combination of the factors between subjects has nobody";

// Each subject's sums over the other factors within: subjects x levels.  Nothing is divided, so
// exact residues stay exact.
std::vector<Real>
subject_sums(const RepeatedDesign& design, std::span<const Real> values, std::size_t f) {
    std::vector<std::size_t> sizes;
    for (const auto& factor : design.within)
        sizes.push_back(factor.levels);
    const auto inner = stride(sizes, f), cells = values.size() / design.groups.size();
    const auto levels = design.within[f].levels;
    std::vector<Real> sums(design.groups.size() * levels, 0);
    for (std::size_t o = 0; o < design.groups.size(); ++o)
        for (std::size_t c = 0; c < cells; ++c)
            sums[o * levels + c / inner % levels] += values[o * cells + c];
    return sums;
}

class WithinPairs {
  public:
    WithinPairs(const RepeatedDesign& design, std::span<const Real> values, double level)
        : design_(design), values_(values), level_(level), groups_(members_of_groups(design)) {}

    MarginalMeans of(std::size_t f) const {
        MarginalMeans found;
        found.factor = f;
        const auto levels = design_.within[f].levels;
        found.reason = somebody_in_every_group(design_, groups_.size()) ? why_no_pairs(levels)
                                                                        : std::string(nobody);
        if (!found.reason.empty())
            return found;
        const auto others = static_cast<Real>(combinations_without(design_.within, f));
        const auto sums = subject_sums(design_, values_, f);
        const auto column = [&](std::size_t i) {
            std::vector<Real> result;
            for (std::size_t o = 0; o < design_.groups.size(); ++o)
                result.push_back(sums[o * levels + i]);
            return result;
        };
        std::vector<Difference> differences;
        for (std::size_t i = 0; i < levels; ++i) {
            const auto first = column(i);
            found.mean.push_back(static_cast<double>(unweighted(first).mean / others));
            for (std::size_t j = i + 1; j < levels; ++j) {
                auto apart = column(j);
                for (std::size_t o = 0; o < apart.size(); ++o)
                    apart[o] = first[o] - apart[o];
                const auto estimate = unweighted(apart);
                differences.push_back({i, j, static_cast<double>(estimate.mean / others),
                                       static_cast<double>(estimate.standard_error / others)});
            }
        }
        const auto df = static_cast<double>(design_.groups.size() - groups_.size());
        found.t = t_of_differences(differences, df, level_);
        std::vector<std::pair<std::size_t, std::size_t>> significant;
        for (const auto& pair : found.t)
            if (pair.significant_holm)
                significant.emplace_back(pair.first, pair.second);
        found.letters = letters_by_means(found.mean, significant);
        return found;
    }

  private:
    struct Estimate {
        Real mean = 0, standard_error = 0;
    };

    // The mean of the groups' means, and its error from the spread within groups.
    Estimate unweighted(std::span<const Real> values) const {
        Real mean = 0, squares = 0, sizes = 0, largest = 0;
        const auto groups = static_cast<Real>(groups_.size());
        for (const auto& [levels, members] : groups_) {
            const auto n = static_cast<Real>(members.size());
            Real own = 0;
            for (const auto o : members) {
                own += values[o] / n;
                largest = std::max(largest, std::abs(values[o]));
            }
            for (const auto o : members)
                squares += (values[o] - own) * (values[o] - own);
            mean += own / groups;
            sizes += 1 / n;
        }
        const auto n = static_cast<Real>(values.size());
        squares = without_rounding(squares, largest, values.size());
        return {mean, std::sqrt(squares / (n - groups) * sizes) / groups};
    }

    const RepeatedDesign& design_;
    std::span<const Real> values_;
    double level_;
    std::map<std::vector<std::size_t>, std::vector<std::size_t>> groups_;
};

} // namespace

std::vector<MarginalMeans> marginal_means(const std::vector<Factor>& factors,
                                          std::span<const Cell> cells,
                                          std::span<const long double> cell_means,
                                          Variation error,
                                          double level) {
    EXPECTS(cells.size() == cell_means.size() && !cells.empty());
    const bool filled = cells.size() == combinations_without(factors, factors.size());
    std::vector<MarginalMeans> found;
    for (std::size_t f = 0; f < factors.size(); ++f) {
        if (filled) {
            found.push_back(means_of_factor(factors, f, cells, cell_means, error, level));
        } else {
            found.emplace_back().factor = f;
            found.back().reason = "some combination of levels has no values";
        }
    }
    return found;
}

std::vector<MarginalMeans> marginal_means_within(const RepeatedDesign& design,
                                                 std::span<const long double> values,
                                                 double level) {
    const WithinPairs pairs(design, values, level);
    std::vector<MarginalMeans> found;
    for (std::size_t f = 0; f < design.within.size(); ++f)
        found.push_back(pairs.of(f));
    return found;
}

std::vector<MarginalMeans> marginal_means_between(const RepeatedDesign& design,
                                                  std::span<const long double> values,
                                                  double level) {
    const auto observers = design.groups.size(), cells = values.size() / observers;
    std::vector<Cell> groups;
    std::vector<Real> means;
    Real squares = 0;
    const auto subject_mean = [&](std::size_t o) {
        Real sum = 0;
        for (std::size_t c = 0; c < cells; ++c)
            sum += values[o * cells + c];
        return sum / static_cast<Real>(cells);
    };
    for (const auto& [levels, members] : members_of_groups(design)) {
        Real mean = 0;
        for (const auto o : members)
            mean += subject_mean(o) / static_cast<Real>(members.size());
        for (const auto o : members)
            squares += (subject_mean(o) - mean) * (subject_mean(o) - mean);
        groups.push_back({levels, members.size()});
        means.push_back(mean);
    }
    Real largest = 0;
    for (const auto value : values)
        largest = std::max(largest, std::abs(value));
    const Variation error{static_cast<double>(without_rounding(squares, largest, values.size())),
                          static_cast<double>(observers - groups.size())};
    auto found = marginal_means(design.between, groups, means, error, level);
    for (auto& factor : found)
        if (factor.mean.empty() && !somebody_in_every_group(design, groups.size()))
            factor.reason = nobody;
    return found;
}

} // namespace analysis::anova
