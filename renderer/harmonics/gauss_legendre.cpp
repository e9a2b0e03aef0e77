// Nodes and weights by Newton's iteration on the Legendre polynomial.
#include "renderer/harmonics/gauss_legendre.h"

#include "renderer/contract.h"

#include <cmath>
#include <numbers>

namespace renderer::harmonics {

namespace {

struct LegendreValue {
    double p;          ///< P_n(x)
    double derivative; ///< P_n'(x)
};

/// For n >= 1 and x inside (-1, 1).
LegendreValue legendre(int n, double x) {
    double before = 1, p = x;
    for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
    }
    return {p, n * (before - x * p) / (1 - x * x)};
}

} // namespace

/// Roots of P_n by Newton's iteration from Tricomi's guess; five steps suffice, ten are taken.
std::vector<GaussNode> gauss_legendre(int n) {
    EXPECTS(n >= 1);
    std::vector<GaussNode> nodes;
    for (int i = 0; i < n; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
        for (int step = 0; step < 10; ++step) {
            const auto [p, derivative] = legendre(n, x);
            x -= p / derivative;
        }
        const double derivative = legendre(n, x).derivative;
        nodes.push_back({x, 2 / ((1 - x * x) * derivative * derivative)});
    }
    return nodes;
}

double legendre_polynomial(int l, double x) {
    EXPECTS(l >= 0);
    double before = 0, p = 1;
    for (int k = 1; k <= l; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
    }
    return p;
}

} // namespace renderer::harmonics
