// What a fitted scale can be tested for.
#pragma once

#include "analysis/numerics/distributions.h"
#include "analysis/scaling/choice_fit.h"
#include "analysis/scaling/choice_terms.h"
#include "analysis/scaling/counts.h"

#include <span>
#include <vector>

namespace analysis::scaling {

// Fits are maximum likelihood, in the link's own unit (not JOD); what needs one and gets another
// answers NaN.  All p-values but the cluster-robust errors' take every vote for independent.

struct ChiSquaredTest {
    double chi_squared = 0;
    double df = 0;
    numerics::Tail p; ///< NaN without degrees of freedom
};

/// All conditions alike, against the fit: t - 1 degrees of freedom.
ChiSquaredTest equality_test(const WinCounts& counts, const ChoiceFit& fit);

/// One more parameter: `larger` contains `smaller` (side effect: 1 degree of freedom).
ChiSquaredTest likelihood_ratio_test(const ChoiceFit& smaller, const ChoiceFit& larger, double df);

/// The fit against one free probability per pair: compared pairs minus (t - 1) degrees of freedom.
struct GoodnessOfFit {
    ChiSquaredTest g2; ///< likelihood ratio
    ChiSquaredTest x2; ///< Pearson
};

GoodnessOfFit goodness_of_fit(const WinCounts& counts, const ChoiceFit& fit, Link link);

/// One scale for all parts (scenes, groups of observers) against one for each:
/// (parts - 1)(t - 1) degrees of freedom.  NaN when some part has no finite scale of its own.
ChiSquaredTest heterogeneity_test(std::span<const WinCounts> parts, Link link);

struct WaldPair {
    std::size_t a = 0, b = 0;
    double difference = 0; ///< theta_a - theta_b
    double standard_error = 0;
    double z = 0;
    numerics::Tail p; ///< two-sided
};

/// Every pair a < b, with the errors of `fit.covariance` (put the cluster-robust one there to use
/// it).
std::vector<WaldPair> wald_pairs(const ChoiceFit& fit);

enum class SmallSample { AsIs, Corrected };

/// Covariance of theta when votes of one observer hang together: H^+ (sum of g g^T over observers)
/// H^+, times N / (N - 1) when corrected.  t x t row-major.  `observers` sum to the counts fitted.
std::vector<double> cluster_robust_covariance(const ChoiceFit& fit,
                                              std::span<const WinCounts> observers,
                                              Link link,
                                              SmallSample correction);

} // namespace analysis::scaling
