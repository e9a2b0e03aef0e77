// Bradley and Terry's scale: the log-odds that one condition is chosen over another are the
// difference of their scores.  [Bradley1952], [Firth1993], [Davidson1970]
#pragma once

#include "analysis/scaling/choice_fit.h"
#include "analysis/scaling/counts.h"

namespace analysis::scaling {

// Scores are in natural log-odds, centred.  Data that put no finite scale on their conditions are
// answered, not refused: the estimate says what was done and `reason` why.  Errors: EXPECTS at
// least one condition and spans of t x t counts, none negative.

/// Maximum likelihood where it is finite; Firth's where conditions are separated; None where they
/// are disconnected (fit each component on its own).
ChoiceFit fit_bradley_terry(const WinCounts& counts);

/// Penalised by Jeffreys' prior: finite whenever the conditions are connected, less biased always.
ChoiceFit fit_bradley_terry_firth(const WinCounts& counts);

/// Penalised by lambda/2 sum (theta - mean)^2, lambda > 0: a Gaussian prior of variance 1/lambda.
/// Finite always; disconnected components are each centred.
ChoiceFit fit_bradley_terry_ridge(const WinCounts& counts, double lambda);

/// With a constant added in favour of the condition shown first.  None where the order is
/// confounded (every pair shown one way only, or in a pattern that a scale imitates) or where the
/// maximum is infinite.  Ties count for nobody.
ChoiceFit fit_bradley_terry_sides(const OrderedCounts& counts);

enum class Sides { Ignored, Fitted };

/// With ties as an answer of their own.  Without a single tie, nu is 0: it is left out, and
/// `reason` says so.
ChoiceFit fit_davidson(const OrderedCounts& counts, Sides sides);

/// exp(theta) over their sum: each condition's share if all competed at once.
std::vector<double> worths(const ChoiceFit& fit);

} // namespace analysis::scaling
