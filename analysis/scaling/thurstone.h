// Thurstone's Case V: conditions are chosen by comparing two normal impressions of equal spread.
// [Thurstone1927]
#pragma once

#include "analysis/scaling/choice_fit.h"
#include "analysis/scaling/counts.h"

namespace analysis::scaling {

/// JOD per unit of the deviation of a difference, 1 / Phi^-1(3/4): a difference of 1 JOD is chosen
/// 75 % of the time.
inline constexpr double jod_sigma = 1.482602218505602;

/// Scores in units of the standard deviation of a difference, centred.  Maximum likelihood where it
/// is finite; ridge with lambda 1 (a Gaussian prior of one such unit) where conditions are
/// separated; None where they are disconnected.  Errors as fit_bradley_terry.
ChoiceFit fit_thurstone(const WinCounts& counts);

/// Penalised by lambda/2 sum (theta - mean)^2 in those units, lambda > 0.
ChoiceFit fit_thurstone_ridge(const WinCounts& counts, double lambda);

/// fit_thurstone in just-objectionable differences.
ChoiceFit fit_thurstone_jod(const WinCounts& counts);

} // namespace analysis::scaling
