// The likelihood of choices between conditions on a scale, and its maximum by Newton's method.
// [Bradley1952], [Thurstone1927], [Firth1993], [Davidson1970]
#pragma once

#include "analysis/scaling/choice_terms.h"
#include "analysis/scaling/cholesky.h"

#include <cstddef>
#include <span>
#include <vector>

namespace analysis::scaling {

/// One pair in one order, and how the votes fell.
struct Comparison {
    std::size_t first = 0;
    std::size_t second = 0;
    double first_wins = 0;
    double second_wins = 0;
    double ties = 0;
};

/// What is estimated beside the scores, and with which penalty.  Ties (Davidson) and Firth go with
/// the logit only, and not together.
struct ModelTerms {
    Link link = Link::Logit;
    bool side = false;
    bool ties = false;
    bool firth = false;
    double ridge = 0; ///< lambda of (lambda / 2) sum (theta - mean)^2
};

/// Objective, gradient and information of a model at given parameters.
struct ModelPoint {
    double log_likelihood = 0;    ///< without the penalty
    double objective = 0;         ///< with it
    std::vector<double> gradient; ///< of the objective
    std::vector<double>
        information; ///< minus the Hessian (for Firth: expected, unpenalised), p x p
};

/// The parameters are theta (t), then side, then ln nu, as far as the terms have them.
class ChoiceModel {
  public:
    ChoiceModel(std::size_t conditions, std::vector<Comparison> comparisons, ModelTerms terms);

    std::size_t parameters() const { return parameters_; }

    /// Other votes on the same pairs, in the same order; keeps the memory.
    std::vector<Comparison>& comparisons() { return comparisons_; }

    /// Fills `point`; false when Firth's penalty cannot be computed (the pairs are disconnected).
    bool evaluate(std::span<const double> parameters, ModelPoint& point);

    struct Maximum {
        std::vector<double> parameters; ///< theta centred
        double log_likelihood = 0;
        int iterations = 0;
        bool converged = false;
    };

    /// Newton's steps from `start` (empty: 0) with halving while the objective falls, until one is
    /// no larger than `close` relative to the scores: rounding size, or, where a thousand fits are
    /// wanted, its root, for what is left after such a step is of its square.  Whether a finite
    /// maximum exists is decided elsewhere, before.
    Maximum maximise(std::span<const double> start = {}, double close = 1e-15);

    /// Inverse of the information at `parameters` on the subspace of centred scores, p x p.
    std::vector<double> covariance(std::span<const double> parameters);

  private:
    void add_pair(const Comparison& pair, std::span<const double> parameters, ModelPoint& point);
    void
    add_tied_pair(const Comparison& pair, std::span<const double> parameters, ModelPoint& point);
    void add_ridge(std::span<const double> parameters, ModelPoint& point) const;
    bool add_firth(std::span<const double> parameters, ModelPoint& point);
    double fill_null_space(std::vector<double>& information) const;
    bool factor(const ModelPoint& point, double& filled);
    void newton_step(const ModelPoint& point, std::vector<double>& step);

    std::size_t t_, parameters_, side_at_ = 0, nu_at_ = 0;
    std::vector<Comparison> comparisons_;
    ModelTerms terms_;
    Cholesky cholesky_;
    std::vector<double> matrix_;
};

} // namespace analysis::scaling
