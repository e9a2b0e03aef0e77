// The range of k standard normals: the largest difference among them, which the studentized range
// takes over an unknown standard deviation.  Both tails by trapezoids, as logarithms.
#pragma once

#include <cstddef>
#include <vector>

namespace analysis::numerics {

/// Of `k` >= 2 normals; the grids in z serve every w.  `step_scale` multiplies the steps.
class NormalRange {
  public:
    NormalRange(double k, double step_scale);

    /// ln P(range > w), w > 0.
    long double log_upper(long double w);

    /// ln P(range < w), w > 0.
    long double log_lower(long double w);

  private:
    struct Node {
        double z, density, tail, weight; ///< weight = density Q(z)^n
    };

    void lay_grid();
    double upper(long double w);
    long double lower_log(double w) const;

    double k_, n_, upper_step_, lower_step_;
    int first_ = 0;
    std::vector<Node> grid_;
};

/// The upper tail over exp(-w^2 / 4), by which it falls: an entire function that hardly changes, so
/// short pieces of it are polynomials to the last bit.  A piece is made when it is first asked for,
/// after which a tail costs a polynomial.
class NormalRangePieces {
  public:
    explicit NormalRangePieces(double k);

    /// ln P(range > w), w > 0.
    long double log_upper(long double w);

  private:
    std::vector<long double> made(std::size_t place);

    NormalRange range_;
    std::vector<std::vector<long double>> pieces_;
};

} // namespace analysis::numerics
