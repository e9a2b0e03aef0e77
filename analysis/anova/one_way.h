// One-way analysis of variance between groups.  [Fisher1925]; effect sizes [OlejnikAlgina2003]
#pragma once

#include "analysis/anova/f_test.h"

#include <cstdint>
#include <span>
#include <vector>

namespace analysis::anova {

struct OneWay {
    std::vector<std::int64_t> n; ///< values in each group
    std::vector<double> mean;
    std::vector<double> variance; ///< within each group, n - 1 below; NaN for one value
    double grand_mean = undefined;
    Variation between;
    Variation within;
    FTest test;
    double residual_sd = undefined;
    double eta_squared = undefined;
    double omega_squared = undefined; ///< as computed, also when negative
    double epsilon_squared = undefined;
};

/// Groups of real values.  EXPECTS at least two groups, none empty.
OneWay one_way(std::span<const std::vector<double>> groups);

/// Groups of equal size of integers, each `1/divisor` of a score: sums of squares are exact.
OneWay one_way_of_counts(std::span<const std::vector<std::int64_t>> groups, std::int64_t divisor);

} // namespace analysis::anova
