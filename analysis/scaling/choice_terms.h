// What one pair of conditions adds to the likelihood of a choice model.
#pragma once

namespace analysis::scaling {

/// P(first chosen) as a function of the difference d = theta_first - theta_second (+ side):
/// 1 / (1 + e^-d), or Phi(d) with d in units of the deviation of a difference.
enum class Link { Logit, Probit };

/// ln L of the votes on a pair and its derivatives in d; `curvature` is minus the second.
struct PairTerm {
    double log_likelihood = 0;
    double slope = 0;
    double curvature = 0;
};

/// Accurate for any d: the likelihood never leaves logarithms, and the slope keeps its digits both
/// near d = 0 under 10^9 votes and where one side wins a million to one.
PairTerm logit_term(double d, double first_wins, double second_wins);
PairTerm probit_term(double d, double first_wins, double second_wins);

/// The same with ties, P(first) : P(second) : P(tie) = e^(d/2) : e^(-d/2) : e^log_nu.
struct TiedPairTerm {
    double log_likelihood = 0;
    double slope = 0;    ///< in d
    double slope_nu = 0; ///< in log_nu
    double curvature = 0;
    double curvature_cross = 0;
    double curvature_nu = 0;
};

TiedPairTerm
davidson_term(double d, double log_nu, double first_wins, double second_wins, double ties);

/// P(first chosen) at d.
double choice_probability(Link link, double d);

} // namespace analysis::scaling
