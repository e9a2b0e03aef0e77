// How sure a scale is when observers differ: observers are drawn again, with all their votes.
// [Efron1987]
#pragma once

#include "analysis/scaling/choice_fit.h"
#include "analysis/scaling/choice_terms.h"
#include "analysis/scaling/counts.h"

#include <cstdint>
#include <span>
#include <vector>

namespace analysis::scaling {

struct BootstrapOptions {
    int replicates = 2000;
    std::uint64_t seed = 0;
    double level = 0.95; ///< of the intervals
    Link link = Link::Logit;
    unsigned threads = 0; ///< 0: every core; results are the same for any number
};

/// Bounds of a confidence interval, in the unit of what was bootstrapped.
struct Interval {
    double lower = 0;
    double upper = 0;
    double lower_error = 0; ///< Monte-Carlo standard error of the bound, from its neighbours' ranks
    double upper_error = 0;
    bool clamped = false;  ///< BCa asked for a level beyond the outermost replicates
    bool constant = false; ///< every replicate gave the same value: the bounds are that point
};

/// With N observers percentile intervals are short by about sqrt((N - 1) / N): 5 % for ten.
struct Bootstrap {
    BootstrapOptions options;
    ChoiceFit fit;                  ///< of the votes as they are; None leaves the rest empty
    int penalised = 0;              ///< replicates without a finite maximum: Firth (probit: ridge)
    int disconnected = 0;           ///< replicates without a common scale: left out of everything
    std::vector<double> replicates; ///< theta, one row of t after another, centred, kept ones only
    std::vector<double> jackknife;  ///< theta without each observer, N rows of t
    std::vector<double> mean;       ///< of the replicates
    std::vector<double> standard_error;
    std::vector<double> covariance;   ///< t x t row-major
    std::vector<Interval> percentile; ///< of each theta
    std::vector<Interval> bca;        ///< the same, corrected for bias and for skewness
    std::vector<double> first;        ///< share of replicates in which it is first (ties shared)
    std::vector<double> above;        ///< t x t: share in which the row is above the column

    int kept() const { return options.replicates - disconnected; }
};

/// `observers` are their win matrices; a replicate is drawn from its own stream of the seed.
/// Errors: EXPECTS at least one observer, all of as many conditions, and 1 or more replicates.
Bootstrap bootstrap(std::span<const WinCounts> observers, const BootstrapOptions& options);

/// Intervals of any value computed from each replicate (a difference, a score in JOD).
/// Errors: EXPECTS at least one replicate and 0 < level < 1.
Interval percentile_interval(std::vector<double> replicates, double level);

/// `estimate` is the value of the votes as they are, `jackknife` its values without each observer.
Interval bca_interval(std::vector<double> replicates,
                      double estimate,
                      std::span<const double> jackknife,
                      double level);

} // namespace analysis::scaling
