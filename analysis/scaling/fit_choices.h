// From counts to a ChoiceFit: what the Bradley-Terry and Thurstone fits share.
#pragma once

#include "analysis/scaling/choice_fit.h"
#include "analysis/scaling/choice_model.h"
#include "analysis/scaling/counts.h"

#include <string>
#include <vector>

namespace analysis::scaling {

/// Every pair with a vote, in the order (0,1), (0,2), ..., with its wins both ways.
std::vector<Comparison> comparisons_of(const WinCounts& counts);

/// Every ordered pair that was shown.
std::vector<Comparison> comparisons_of(const OrderedCounts& counts);

/// Maximises and reads off scores, covariance and nuisance parameters; `found` goes into the fit.
/// When the steps did not converge the estimate is None, with its reason.
ChoiceFit fit_choices(std::size_t conditions,
                      std::vector<Comparison> comparisons,
                      ModelTerms terms,
                      Existence found);

/// A fit without scores.
ChoiceFit no_scale(std::size_t conditions, Existence found, std::string reason);

/// "{0} above {1, 2, 3}" or "{0, 1} apart from {2, 3}", conditions by index.
std::string describe(const Existence& found);

} // namespace analysis::scaling
