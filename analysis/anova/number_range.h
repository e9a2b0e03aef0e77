// Squares leave the range of a double long before the values do: such values are analysed in
// another unit.
#pragma once

#include "analysis/anova/measurements.h"

#include <string>

namespace analysis::anova {

/// The power of ten by which values are divided before they are analysed: 0 where sums of their
/// squares are doubles with all digits.
int unit_exponent(const Measurements& table);

/// The same values, exactly, in units of 10^exponent.
Measurements in_unit(Measurements table, int exponent);

/// What that means for the numbers of an analysis, as a sentence.
std::string note_on_unit(const std::string& response, int exponent);

} // namespace analysis::anova
