// Orthonormal contrasts between the levels of repeated factors.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace analysis::anova {

/// Scores of Helmert's contrasts of a box of values, the last axis fastest, axis 0 observers.
/// Along axes whose bit is in `set` (bit a: axis a) levels become their contrasts, one fewer; along
/// the other axes but 0 they are averaged, and weighted so that every contrast has unit length.
/// Row-major observers x contrasts.  Errors: EXPECTS the size of `values`.
std::vector<long double> contrast_scores(std::span<const std::size_t> sizes,
                                         std::span<const long double> values,
                                         unsigned set);

} // namespace analysis::anova
