// Gauss-Legendre quadrature: integrals over an interval, exact for polynomials.
#pragma once

#include <vector>

namespace renderer::harmonics {

struct GaussNode {
    double x, weight;
};

/// n nodes on (-1, 1), exact for polynomials up to degree 2n-1; the weights add up to 2.
/// Errors: EXPECTS n >= 1.
std::vector<GaussNode> gauss_legendre(int n);

/// P_l(x), by the recurrence over degrees.
/// Errors: EXPECTS l >= 0.
double legendre_polynomial(int l, double x);

} // namespace renderer::harmonics
