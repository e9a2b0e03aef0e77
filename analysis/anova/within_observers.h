// Analysis of variance within observers: every observer has one score in every cell of 1..6
// factors, each effect is tested against its own interaction with observers.  Score counts are
// decomposed in integers, so what cannot vary is exactly zero.
#pragma once

#include "analysis/anova/effect_size.h"
#include "analysis/anova/f_test.h"
#include "analysis/anova/sphericity.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace analysis::anova {

struct Factor {
    std::string name;
    std::size_t levels = 0;
};

struct WithinEffect {
    std::string name; ///< factor names joined by ':'
    std::vector<std::size_t> factors;
    Variation effect;
    Variation error; ///< effect x observer
    FTest test;
    double eta_squared_partial = undefined;
    double eta_squared_generalized = undefined; ///< all factors manipulated
    EtaInterval eta_interval{undefined,
                             undefined}; ///< of the partial one; filled by who knows a level
    Sphericity sphericity;               ///< empty for effects on one degree of freedom
};

struct WithinAnalysis {
    std::size_t observers = 0;
    std::vector<Factor> factors;
    std::vector<WithinEffect> effects; ///< by number of factors, then in the order of factors
    Variation subject;                 ///< between observers
    Variation total;
};

/// `values` holds observers x levels of factor 0 x levels of factor 1 ..., the last fastest.
/// `divisor` of the integers make one unit of score.
/// Errors: EXPECTS at least 2 observers, 1..6 factors of at least 2 levels, and the size.
WithinAnalysis within_observers_of_counts(std::size_t observers,
                                          std::vector<Factor> factors,
                                          std::span<const std::int64_t> values,
                                          std::int64_t divisor);

/// The same for real scores; zero then means zero within rounding.
WithinAnalysis within_observers(std::size_t observers,
                                std::vector<Factor> factors,
                                std::span<const double> values);

} // namespace analysis::anova
