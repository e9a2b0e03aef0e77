// The studentized range: the largest difference among k normal means over an independent standard
// deviation, which Tukey's comparisons need.  Double trapezoid, both tails summed separately.
// [Tukey1953]
#pragma once

#include "analysis/numerics/distributions.h"

#include <memory>

namespace analysis::numerics {

/// P(Q >= q) for the range of `k` >= 2 standard normals over a standard deviation with `df` > 0
/// degrees of freedom (any real number; infinity for a known one).
/// Relative error below 1e-14, usually 1e-15, from p = 1 to p = 1e-300, then of log10_p.  NaN in,
/// NaN out. `step_scale` multiplies both quadrature steps: the change from 1 to 1/2 estimates the
/// error. Errors: EXPECTS on k, df and step_scale > 0.
Tail studentized_range_upper_tail(double q, double k, double df, double step_scale = 1.0);

/// P(Q <= q), with its own digits where it is small.
Tail studentized_range_lower_tail(double q, double k, double df, double step_scale = 1.0);

/// Upper tails for many q and df of one k: as many digits as `studentized_range_upper_tail`, at a
/// hundredth of the time once some dozens were asked for.
class StudentizedRanges {
  public:
    /// Errors: EXPECTS k >= 2.
    explicit StudentizedRanges(double k);
    ~StudentizedRanges();
    StudentizedRanges(const StudentizedRanges&) = delete;
    StudentizedRanges& operator=(const StudentizedRanges&) = delete;

    /// P(Q >= q).  Runs of the same df are fastest.  Errors: EXPECTS df > 0.
    Tail upper_tail(double q, double df);

  private:
    struct Shared;
    std::unique_ptr<Shared> shared_;
};

/// q with P(Q >= q) = `upper_p`, 0 < upper_p < 1; infinite when it is beyond a double.
double studentized_range_quantile(double upper_p, double k, double df);

} // namespace analysis::numerics
