// Friedman's test where every observer saw only some of the conditions, in a balanced design.
// [Durbin1951]; F form [Conover1999]
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace analysis::consistency {

/// What one observer ranked: conditions by index, and a value for each; more is better.
struct IncompleteBlock {
    std::vector<std::size_t> conditions;
    std::vector<double> values;
};

struct DurbinTest {
    std::vector<double> rank_sums; ///< ties share mid-ranks
    double chi_squared = 0;        ///< T1
    double df = 0;
    double p = 0;
    double f = 0; ///< T2; NaN when all blocks rank alike
    double df1 = 0, df2 = 0;
    double p_f = 0;
    std::string reason; ///< why something is NaN
};

/// NaN with a reason unless the design is balanced: blocks of one size, every condition in as many
/// blocks, every pair of conditions together in as many.
/// Errors: EXPECTS at least one block, a value per condition, indices below `conditions`.
DurbinTest durbin(std::span<const IncompleteBlock> blocks, std::size_t conditions);

} // namespace analysis::consistency
