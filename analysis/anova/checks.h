// Do the groups of a one-way analysis vary alike, and what if they do not?
// [Levene1960], [BrownForsythe1974], [Welch1951]
#pragma once

#include "analysis/anova/f_test.h"
#include "analysis/anova/one_way.h"

#include <cstdint>
#include <span>
#include <vector>

namespace analysis::anova {

/// One-way analysis of distances from the group mean; groups of equal size, exact.
FTest levene(std::span<const std::vector<std::int64_t>> groups);

/// One-way analysis of distances from the group median.
FTest brown_forsythe(std::span<const std::vector<std::int64_t>> groups);

/// The same for groups of any sizes of real values.
FTest levene(std::span<const std::vector<double>> groups);
FTest brown_forsythe(std::span<const std::vector<double>> groups);

/// One-way analysis that does not assume equal variances; undefined when a group does not vary.
FTest welch(const OneWay& groups);

} // namespace analysis::anova
