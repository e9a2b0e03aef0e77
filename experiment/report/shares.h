// Votes of a row over a column, as counts, shares and colours.
#pragma once

#include "analysis/findings.h"

#include <string>

namespace experiment::report {

/// The matrix of all votes.  EXPECTS findings with the scope "all".
const analysis::VoteMatrix& pooled_matrix(const analysis::Findings& findings);

/// Votes for `row` over `column`; a tie counts one half.
double votes_over(const analysis::VoteMatrix& matrix, std::size_t row, std::size_t column);

/// The same over the number of comparisons, 0..1; NaN where there was none.
double share_over(const analysis::VoteMatrix& matrix, std::size_t row, std::size_t column);

/// "#rrggbb": orange at 0, near white at 0.5, blue at 1 (told apart by colour-blind eyes); light
/// enough for dark text.  White for NaN.
std::string share_colour(double share);

} // namespace experiment::report
