// How well each observer's votes are foretold by everybody else's.
#pragma once

#include "analysis/scaling/choice_fit.h"
#include "analysis/scaling/choice_terms.h"
#include "analysis/scaling/counts.h"

#include <span>
#include <vector>

namespace analysis::scaling {

/// Reported, never acted on.  When observers truly differ, z spreads beyond a standard normal.
struct LeftOut {
    ChoiceFit others;          ///< fit to everybody else
    double log_likelihood = 0; ///< of the left-out observer's votes under it
    double log_likelihood_per_vote = 0;
    double expected = 0;           ///< of that log-likelihood, were the observer like the others
    double variance = 0;           ///< of it
    double z = 0;                  ///< (log_likelihood - expected) / sqrt(variance); low is odd
    std::vector<double> own_theta; ///< ridge (lambda 0.1) scores of the observer alone
};

/// One element per observer.  NaN where the others have no scale, or the observer no votes.
/// Errors: EXPECTS at least two observers of as many conditions.
std::vector<LeftOut> leave_one_out(std::span<const WinCounts> observers, Link link);

} // namespace analysis::scaling
