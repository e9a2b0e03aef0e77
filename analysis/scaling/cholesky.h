// Small symmetric positive definite systems: an information matrix of a few dozen scores.
#pragma once

#include <span>
#include <vector>

namespace analysis::scaling {

/// L D L^T of a row-major n x n matrix; the memory is kept between factorisations.
class Cholesky {
  public:
    /// Reads the lower triangle.  False when the matrix is not positive definite.
    bool factor(std::span<const double> matrix, std::size_t n);

    /// Overwrites `b` (n elements) with the solution.
    void solve(std::span<double> b) const;

    double log_determinant() const;

    /// Row-major n x n, exactly symmetric.
    std::vector<double> inverse() const;

  private:
    std::size_t n_ = 0;
    std::vector<double> lower_; // unit lower triangle below, D on the diagonal
};

} // namespace analysis::scaling
