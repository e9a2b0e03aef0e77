// p-values adjusted for how many were looked at.  Equal p stay equal, NaN stays NaN and does not
// count.  [Holm1979], [Hochberg1988], [BenjaminiHochberg1995]
#pragma once

#include <span>
#include <vector>

namespace analysis::anova {

std::vector<double> bonferroni(std::span<const double> p);
std::vector<double> holm(std::span<const double> p);
std::vector<double> hochberg(std::span<const double> p);
std::vector<double> benjamini_hochberg(std::span<const double> p);

} // namespace analysis::anova
