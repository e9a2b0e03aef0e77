#include "analysis/anova/repeated.h"

#include "analysis/anova/contrasts.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace analysis::anova {

namespace {

using Real = long double;

// Groups of observers that share the levels of all between factors.
struct Groups {
    std::vector<Cell> cells;
    std::vector<int> of_observer;

    explicit Groups(const std::vector<std::vector<std::size_t>>& levels) {
        std::map<std::vector<std::size_t>, int> known;
        for (const auto& combination : levels)
            known.emplace(combination, 0);
        for (auto& [combination, number] : known) {
            number = static_cast<int>(cells.size());
            cells.push_back({combination, 0});
        }
        for (const auto& combination : levels) {
            of_observer.push_back(known.at(combination));
            ++cells[static_cast<std::size_t>(of_observer.back())].count;
        }
    }
};

// One contrast of the within design as a between design of its own.
struct ContrastParts {
    std::vector<TermSquares> terms;
    Real error = 0;
};

ContrastParts parts_of(const ModelComparison& model,
                       const Groups& groups,
                       std::span<const Real> scores,
                       SumsOfSquares type) {
    std::vector<Real> means(groups.cells.size(), 0);
    for (std::size_t o = 0; o < scores.size(); ++o)
        means[static_cast<std::size_t>(groups.of_observer[o])] += scores[o];
    for (std::size_t g = 0; g < means.size(); ++g)
        means[g] /= static_cast<Real>(groups.cells[g].count);
    ContrastParts parts{model.squares(means, type), 0};
    for (std::size_t o = 0; o < scores.size(); ++o) {
        const Real apart = scores[o] - means[static_cast<std::size_t>(groups.of_observer[o])];
        parts.error += apart * apart;
    }
    return parts;
}

std::string name_of(const RepeatedDesign& design, const RepeatedEffect& effect) {
    std::string name;
    for (const auto f : effect.between)
        name += (name.empty() ? "" : ":") + design.between[f].name;
    for (const auto f : effect.within)
        name += (name.empty() ? "" : ":") + design.within[f].name;
    return name;
}

class Analysis {
  public:
    Analysis(const RepeatedDesign& design, std::span<const Real> values, SumsOfSquares type)
        : design_(design), values_(values), type_(type), groups_(design.groups),
          model_(design.between, groups_.cells) {
        sizes_.push_back(design.groups.size());
        for (const auto& factor : design.within)
            sizes_.push_back(factor.levels);
        Real largest = 0;
        for (const auto value : values)
            largest = std::max(largest, std::abs(value));
        // Sums of n terms of this size cannot be told from zero below this.
        const Real rounding =
            largest * static_cast<Real>(values.size()) * std::numeric_limits<Real>::epsilon();
        negligible_ = rounding * rounding;
    }

    RepeatedAnalysis run() {
        stratum({}, 0);
        for (const auto& within : factorial_terms(design_.within.size())) {
            unsigned set = 0;
            for (const auto f : within)
                set |= 2U << f; // bit 0 is the observers' axis
            stratum(within, set);
        }
        total();
        generalised_eta();
        return std::move(result_);
    }

  private:
    // Everything that is tested against one error: observers, or observers x a within effect.
    void stratum(const std::vector<std::size_t>& within, unsigned set) {
        const auto observers = design_.groups.size();
        const auto scores = contrast_scores(sizes_, values_, set);
        const auto contrasts = scores.size() / observers;
        const auto first = result_.effects.size();
        Real error_squares = 0;
        std::vector<TermSquares> sums;
        std::vector<Real> column(observers);
        for (std::size_t k = 0; k < contrasts; ++k) {
            for (std::size_t o = 0; o < observers; ++o)
                column[o] = scores[o * contrasts + k];
            const auto parts = parts_of(model_, groups_, column, type_);
            sums.resize(parts.terms.size());
            for (std::size_t term = 0; term < sums.size(); ++term) {
                sums[term].ss += parts.terms[term].ss;
                sums[term].df += parts.terms[term].df;
            }
            error_squares += parts.error;
        }
        const auto error_df =
            static_cast<double>(contrasts) * static_cast<double>(observers - groups_.cells.size());
        const Variation error{checked(error_squares), error_df};
        const auto terms = factorial_terms(design_.between.size());
        for (std::size_t term = within.empty() ? 1 : 0; term < sums.size(); ++term) {
            RepeatedEffect effect;
            effect.between = term == 0 ? std::vector<std::size_t>{} : terms[term - 1];
            effect.within = within;
            effect.name = name_of(design_, effect);
            effect.effect = {checked(sums[term].ss), sums[term].df};
            effect.error = error;
            effect.test = f_test(effect.effect, effect.error);
            if (effect.effect.ss + error.ss > 0)
                effect.eta_squared_partial = effect.effect.ss / (effect.effect.ss + error.ss);
            result_.effects.push_back(std::move(effect));
        }
        if (contrasts > 1)
            add_sphericity(first, scores, contrasts);
        result_.residual.ss += error.ss;
        result_.residual.df += error.df;
    }

    void add_sphericity(std::size_t first, const std::vector<Real>& scores, std::size_t contrasts) {
        const std::vector<double> rounded(scores.begin(), scores.end());
        std::size_t cells = 1;
        for (const auto& factor : design_.within)
            cells *= factor.levels;
        for (std::size_t e = first; e < result_.effects.size(); ++e)
            result_.effects[e].sphericity =
                sphericity(rounded, groups_.of_observer, contrasts, cells, result_.effects[e].test);
    }

    void total() {
        Real mean = 0, squares = 0, rest = 0;
        for (const auto value : values_)
            mean += value / static_cast<Real>(values_.size());
        for (const auto value : values_) {
            squares += (value - mean) * (value - mean);
            rest += value - mean;
        }
        const auto n = static_cast<Real>(values_.size());
        result_.total = {checked(squares - rest * rest / n), static_cast<double>(n - 1)};
    }

    void generalised_eta() {
        for (auto& effect : result_.effects)
            if (const double whole = effect.effect.ss + result_.residual.ss; whole > 0)
                effect.eta_squared_generalized = effect.effect.ss / whole;
    }

    double checked(Real squares) const {
        return squares <= negligible_ ? 0.0 : static_cast<double>(squares);
    }

    const RepeatedDesign& design_;
    std::span<const Real> values_;
    SumsOfSquares type_;
    Groups groups_;
    ModelComparison model_;
    std::vector<std::size_t> sizes_;
    Real negligible_ = 0;
    RepeatedAnalysis result_;
};

} // namespace

RepeatedAnalysis
repeated(const RepeatedDesign& design, std::span<const long double> values, SumsOfSquares type) {
    EXPECTS(!design.within.empty() && design.within.size() <= 6 && !design.groups.empty());
    std::size_t cells = design.groups.size();
    for (const auto& factor : design.within) {
        EXPECTS(factor.levels >= 2);
        cells *= factor.levels;
    }
    EXPECTS(values.size() == cells);
    return Analysis(design, values, type).run();
}

} // namespace analysis::anova
