// Least squares with weights that must not be negative, for a handful of unknowns and any number of
// equations.  [LawsonHanson1974]
#pragma once

#include <array>
#include <cstddef>

namespace renderer::pictures {

/// Minimises sum over equations (sum_j a_j x_j - y)^2 over x >= 0.
///
/// Equations are rotated one by one into a triangle, so memory does not grow with their number and
/// nearly dependent columns keep their digits (normal equations would lose half).
class NonnegativeLeastSquares {
  public:
    static constexpr std::size_t unknowns = 4;
    using Weights = std::array<double, unknowns>;

    void add_equation(const Weights& a, double y);

    struct Solution {
        Weights x{};
        double squared_error = 0; ///< what is left, summed over all equations
        std::array<bool, unknowns>
            absent{}; ///< columns that are zero in every equation; their x is 0
    };

    /// Exact: a minimum over x >= 0 is the plain minimum over the unknowns that are not zero in it,
    /// and of four unknowns there are sixteen subsets to try.  Columns that depend on each other
    /// (to 1e-10 of their length) share the burden in many ways; then one of the fewest is given.
    Solution solve() const;

  private:
    static constexpr std::size_t columns = unknowns + 1; // the last is y
    std::array<std::array<double, columns>, columns> triangle_{};
};

} // namespace renderer::pictures
