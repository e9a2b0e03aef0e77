// Analysis of variance with any number of factors within observers and any between them, groups of
// unequal size: the between design is analysed once for every contrast of the within design.
#pragma once

#include "analysis/anova/model_comparison.h"
#include "analysis/anova/sphericity.h"
#include "analysis/anova/within_observers.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace analysis::anova {

struct RepeatedDesign {
    std::vector<Factor> between;
    std::vector<std::vector<std::size_t>> groups; ///< observer's level of each between factor
    std::vector<Factor> within;
};

struct RepeatedEffect {
    std::string name; ///< factor names joined by ':', between factors first
    std::vector<std::size_t> between, within;
    Variation effect;
    Variation error; ///< observers within groups, or their interaction with the within factors
    FTest test;
    double eta_squared_partial = undefined;
    double eta_squared_generalized = undefined; ///< all factors manipulated
    Sphericity sphericity;                      ///< empty on one within degree of freedom
};

struct RepeatedAnalysis {
    std::vector<RepeatedEffect> effects;
    Variation residual; ///< all errors together; no test uses it
    Variation total;    ///< about the grand mean
};

/// `values` holds observers x levels of within factor 0 x ..., the last fastest.
/// Effects that are zero within rounding are zero.
/// Errors: EXPECTS at least one within factor, factors of 2 or more levels, 6 within factors at
/// most, more observers than groups, and for type III no empty group.
RepeatedAnalysis
repeated(const RepeatedDesign& design, std::span<const long double> values, SumsOfSquares type);

} // namespace analysis::anova
