// Decimal data about their first value, in a common unit: what an analysis of variance needs of
// them, without the digits that all of them share.
#pragma once

#include "analysis/numerics/decimal.h"

#include <span>
#include <vector>

namespace analysis::numerics {

/// value i = (origin + residues[i]) 10^exponent.  Residues are exact integers when the data span no
/// more than 38 digits and their differences fit 64 bits; beyond, they are rounded to 64 bits.
struct Shifted {
    std::vector<long double> residues;
    long double origin = 0;
    int exponent = 0;

    /// A mean (or a difference: `from` 0) in the unit of the data.
    double in_data_unit(long double residue, long double from) const;
    /// A sum of squares in the unit of the data; 0 or infinite beyond a double.
    double squares_in_data_unit(long double squares) const;
};

Shifted about_first(std::span<const Decimal> values);

} // namespace analysis::numerics
