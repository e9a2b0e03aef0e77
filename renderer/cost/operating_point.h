// The setting to work with, among those that were measured: the cheapest that is good enough, or
// the best that is fast enough.
#pragma once

#include "renderer/cost/quantiles.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace renderer::cost {

/// A setting as far as the choice is concerned.
struct Candidate {
    Spread frame;          ///< of a frame, any unit
    double error = 0;      ///< NaN: not known, never chosen
    std::size_t bytes = 0; ///< in all
    double precompute_seconds = 0;
};

enum class Rule {
    GoodEnough,    ///< the cheapest within the tolerance
    NothingIsGood, ///< none is within it: the one with the least error
    FastEnough,    ///< the least error within the budget
    NothingIsFast  ///< none is within it: the fastest
};

struct OperatingPoint {
    std::size_t chosen = 0;
    Rule rule = Rule::GoodEnough;
    /// As fast as the chosen one, as far as the spread of the times can tell, and good enough, but
    /// more in memory, in precomputation or in error.
    std::vector<std::size_t> as_fast;
};

/// The fastest whose error is at most `tolerance`.  Whose lower quartile is not above the upper one
/// of the fastest is as fast: of those the one with the fewest bytes, then the least
/// precomputation, then the least error is taken, so that noise does not choose.
/// Nothing when no error is known.
std::optional<OperatingPoint> within_tolerance(std::span<const Candidate> candidates,
                                               double tolerance);

/// The least error whose frame takes at most `budget`, in the median.  Nothing when no error is
/// known.
std::optional<OperatingPoint> within_budget(std::span<const Candidate> candidates, double budget);

} // namespace renderer::cost
