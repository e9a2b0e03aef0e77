// Are residuals normal?  Royston's W.  [ShapiroWilk1965], [Royston1995]
#pragma once

#include <span>
#include <string>

namespace analysis::anova {

struct ShapiroWilk {
    double w = 0;
    double p = 0;
    std::string reason; ///< why w and p are NaN, or why p is to be doubted
};

/// Undefined for fewer than 3 values and for equal ones; p is outside its tested range above 5000.
ShapiroWilk shapiro_wilk(std::span<const double> values);

} // namespace analysis::anova
