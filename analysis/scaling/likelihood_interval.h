// Intervals that follow the likelihood where it is lopsided: every value of a contrast of scores
// that a likelihood-ratio test would not reject.  [Wilks1938]
#pragma once

#include "analysis/scaling/choice_fit.h"
#include "analysis/scaling/choice_terms.h"
#include "analysis/scaling/counts.h"

#include <span>

namespace analysis::scaling {

struct LikelihoodInterval {
    double lower = 0;
    double upper = 0;
};

/// The profile-likelihood interval of sum_i contrast_i theta_i at confidence `level`, in the unit
/// of the link.  It takes every vote for independent.  `fit` must be the maximum of the likelihood
/// of `counts`; NaN where it is anything else, for then an end is infinite.
/// Errors: EXPECTS a contrast of t weights that sum to 0 (within rounding) and 0 < level < 1.
LikelihoodInterval likelihood_interval(const WinCounts& counts,
                                       const ChoiceFit& fit,
                                       Link link,
                                       std::span<const double> contrast,
                                       double level);

/// Of each centred score: the contrast of one condition with the mean of all.
std::vector<LikelihoodInterval>
likelihood_intervals(const WinCounts& counts, const ChoiceFit& fit, Link link, double level);

} // namespace analysis::scaling
