// Are all differences between repeated measures equally variable?  [Mauchly1940],
// [GreenhouseGeisser1959], [HuynhFeldt1976], [Lecoutre1991], [Box1949]
#pragma once

#include "analysis/anova/f_test.h"

#include <span>
#include <string>

namespace analysis::anova {

/// Epsilons multiply both degrees of freedom of the F test.  NaN where undefined.
struct Sphericity {
    double mauchly_w = undefined; ///< needs at least as many observers' df as contrasts
    double chi_squared = undefined;
    double df = undefined;
    double p_chi_squared = undefined;  ///< first order
    double p_second_order = undefined; ///< Box's second term, with the number of contrasts
    double p_as_r = undefined;         ///< the same with the number of raw columns, as R prints it
    double greenhouse_geisser = undefined;
    double huynh_feldt_raw = undefined;
    double huynh_feldt = undefined; ///< min(1, raw)
    double lower_bound = undefined;
    double p_greenhouse_geisser = undefined; ///< of the effect's F
    double p_huynh_feldt = undefined;
    double p_lower_bound = undefined;
    std::string reason; ///< why something above is undefined
};

/// From contrast scores, row-major observers x contrasts (orthonormal contrasts), pooled within
/// groups of observers: `groups` has one code per observer.
/// `raw_columns` is the number of cells the scores came from (for `p_as_r` only); `effect` is the
/// F test the corrected p-values belong to.
Sphericity sphericity(std::span<const double> contrast_scores,
                      std::span<const int> groups,
                      std::size_t contrasts,
                      std::size_t raw_columns,
                      const FTest& effect);

} // namespace analysis::anova
