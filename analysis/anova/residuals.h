// What the analysis within observers leaves over, and whether it looks normal.
#pragma once

#include "analysis/anova/shapiro_wilk.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace analysis::anova {

/// In units of score, observers x levels, the levels fastest.
struct WithinResiduals {
    std::vector<double> fitted;   ///< level mean + observer mean - grand mean
    std::vector<double> residual; ///< score - fitted
    ShapiroWilk normality;        ///< of the residuals
};

/// `counts` is row-major observers x levels, `divisor` of them make a unit of score; exact up to
/// the last division.  EXPECTS at least two observers and levels.
WithinResiduals
within_residuals(std::span<const std::int64_t> counts, std::size_t levels, std::int64_t divisor);

} // namespace analysis::anova
