// The scores of conditions under a choice model, and how sure they are.
#pragma once

#include "analysis/scaling/existence.h"

#include <optional>
#include <string>
#include <vector>

namespace analysis::scaling {

enum class Estimate {
    MaximumLikelihood,
    Firth, ///< Jeffreys prior: finite whenever the conditions are connected
    Ridge, ///< Gaussian prior on the scores
    None   ///< no scale; `reason` says why, scores are NaN
};

/// A parameter that is not a score, with its standard error.
struct Nuisance {
    double value = 0;
    double standard_error = 0;
};

struct ChoiceFit {
    Estimate estimate = Estimate::None;
    std::string reason;             ///< why the estimate is penalised or missing; else empty
    std::vector<double> theta;      ///< scores, sum 0
    std::vector<double> covariance; ///< of theta, t x t row-major, rows sum to 0: from the observed
                                    ///< information, so of independent votes
    double log_likelihood = 0;      ///< natural, without the penalty
    std::optional<Nuisance> side;   ///< added to the difference in favour of the first shown
    std::optional<Nuisance> log_nu; ///< Davidson's ln nu; ties are nu : 1 between equals
    int iterations = 0;
    bool converged = false;
    Existence existence;

    std::size_t conditions() const { return theta.size(); }
};

/// Standard error of one score, and of a difference of two (which needs their covariance).
double standard_error(const ChoiceFit& fit, std::size_t i);
double difference_standard_error(const ChoiceFit& fit, std::size_t i, std::size_t j);

/// The same scores in another unit: theta times `factor`, covariance times its square.
ChoiceFit in_unit(ChoiceFit fit, double factor);

} // namespace analysis::scaling
