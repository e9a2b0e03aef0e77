// Tails of the distributions that test statistics follow, with their logarithms where a double
// ends.
#pragma once

namespace analysis::numerics {

/// A probability and its decimal logarithm.  `p` goes to 0 below the range of a double; `log10_p`
/// then still holds every digit.  Both are NaN where the statistic was undefined (NaN in, NaN out).
struct Tail {
    double p = 0.0;
    double log10_p = 0.0;
};

// Upper tails are summed as such, never as one minus the other.  Degrees of freedom are > 0, need
// not be whole, and may be infinite where that has a meaning.  Errors: EXPECTS on them.  Relative
// error of p, and of log10_p where p underflows: below 1e-13, usually a few 1e-16.

Tail f_upper_tail(double f, double df1, double df2); ///< P(F >= f); f may be infinite
Tail f_lower_tail(double f, double df1, double df2); ///< P(F <= f)
Tail t_upper_tail(double t, double df);              ///< P(T >= t), either sign
Tail t_two_sided(double t, double df);               ///< P(|T| >= |t|)
Tail chi_squared_upper_tail(double x, double df);    ///< P(X >= x)
Tail chi_squared_lower_tail(double x, double df);    ///< P(X <= x)
Tail normal_upper_tail(double z);                    ///< P(Z >= z), either sign

double log_normal_cdf(double z);      ///< ln Phi(z), natural logarithm, for any z
double normal_pdf_over_cdf(double z); ///< phi(z) / Phi(z), for any z

double normal_quantile(double p);                 ///< z with Phi(z) = p, 0 < p < 1
double t_quantile_two_sided(double p, double df); ///< t >= 0 with P(|T| >= t) = p, 0 < p <= 1
double f_quantile_upper(double p, double df1, double df2); ///< f with P(F >= f) = p, 0 < p < 1
double chi_squared_quantile_upper(double p, double df);    ///< x with P(X >= x) = p, 0 < p < 1

/// F with noncentrality lambda >= 0, f >= 0, finite degrees of freedom: a Poisson mixture of
/// central F, summed from its mode outwards.
Tail noncentral_f_upper_tail(double f, double df1, double df2, double lambda); ///< the power at f
Tail noncentral_f_lower_tail(double f, double df1, double df2, double lambda); ///< the cdf at f

} // namespace analysis::numerics
