// How much of what is seen is the conditions, how much the observers' tastes, and how much their
// not answering alike twice.
#pragma once

#include "analysis/anova/f_test.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace analysis::anova {

/// In squared units of score; estimates below 0 are 0.
struct VarianceComponents {
    double condition = undefined;            ///< between conditions
    double observer_x_condition = undefined; ///< observers differ in taste
    double repetition = undefined;           ///< one observer differs from session to session
    double inter_observer_sd = undefined;
    double intra_observer_sd = undefined;
    double reliability = undefined; ///< of the conditions' means, 0..1: share that is condition
    std::string reason;             ///< why the rest is NaN
};

/// `counts` holds observers x sessions x levels, the levels fastest; `divisor` of them make a unit
/// of score.  Undefined for fewer than two observers, sessions or levels.
/// Errors: EXPECTS the size.
VarianceComponents variance_components(std::span<const std::int64_t> counts,
                                       std::size_t observers,
                                       std::size_t sessions,
                                       std::size_t levels,
                                       std::int64_t divisor);

} // namespace analysis::anova
