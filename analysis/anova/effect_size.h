// How sure an effect size is.  [Steiger2004]
#pragma once

namespace analysis::anova {

/// Bounds of partial eta squared, 0..1; NaN where F is not a finite number.
struct EtaInterval {
    double lower = 0;
    double upper = 0;
};

/// The interval at confidence `level`, equal tails: lambda such that F is just not surprising,
/// inverted from the noncentral F, and eta^2 = lambda / (lambda + df1 + df2 + 1).
EtaInterval eta_squared_interval(double f, double df1, double df2, double level);

} // namespace analysis::anova
