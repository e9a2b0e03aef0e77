// Light inside, just below the surface, as its radiance at a few cosines mu from the normal: what
// goes up is what the half-space makes of what goes down, and part of that goes down again.
#include "renderer/half_space.h"

#include "renderer/contract.h"
#include "renderer/diffusion/fresnel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace renderer {

namespace {

using std::numbers::pi;

struct Node {
    double mu;
    double weight;
};

/// Appends the double-exponential rule over [low, high]: exact to 1e-12 for what is smooth inside,
/// however it bends at the ends, as H does at grazing and the mirror at the critical angle.
void append_rule(std::vector<Node>& nodes, double low, double high) {
    constexpr double step = 1.0 / 12, last = 3.25; // the weights at the ends are below 1e-16
    for (double u = -last; u <= last; u += step) {
        const double towards_end = pi / 2 * std::sinh(u);
        const double share = 1 / (1 + std::exp(-2 * towards_end));
        const double slope = pi * std::cosh(u) * share / (1 + std::exp(2 * towards_end));
        nodes.push_back({low + (high - low) * share, (high - low) * step * slope});
    }
}

std::vector<Node> rule(double critical_mu) {
    std::vector<Node> nodes;
    if (critical_mu > 0)
        append_rule(nodes, 0, critical_mu);
    append_rule(nodes, critical_mu, 1);
    return nodes;
}

/// Share that the surface sends back to light that meets it from inside.
double mirrored(double mu, double index) {
    return diffusion::fresnel_reflectance(mu, 1 / index);
}

/// sum over the nodes of mu' H(mu') g(mu') / (mu + mu').
template <class G>
double weighed(const std::vector<Node>& nodes, const std::vector<double>& H, double mu, G&& g) {
    double sum = 0;
    for (std::size_t j = 0; j < nodes.size(); ++j)
        sum += nodes[j].weight * nodes[j].mu * H[j] * g(j) / (mu + nodes[j].mu);
    return sum;
}

/// Chandrasekhar's H for isotropic scattering: 1/H = sqrt(1 - a) + (a/2) int mu' H/(mu + mu').
double
h_function(const std::vector<Node>& nodes, const std::vector<double>& H, double a, double mu) {
    return 1 / (std::sqrt(1 - a) + a / 2 * weighed(nodes, H, mu, [](std::size_t) { return 1.0; }));
}

/// H at the nodes, by iteration.  The mean of two steps goes straight where one goes back and
/// forth.
std::vector<double> h_function(const std::vector<Node>& nodes, double a) {
    std::vector<double> H(nodes.size(), 1.0);
    for (double change = 1; change > 1e-13;) {
        change = 0;
        auto next = H;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            next[i] = (H[i] + h_function(nodes, H, a, nodes[i].mu)) / 2;
            change = std::max(change, std::abs(next[i] - H[i]));
        }
        H = std::move(next);
    }
    return H;
}

} // namespace

double body_reflectance(double albedo, double index, Incidence incidence) {
    EXPECTS(albedo >= 0 && albedo <= 1);
    EXPECTS(index >= 1 && std::isfinite(index));
    const double a = albedo;
    const auto nodes = rule(std::sqrt(1 - 1 / (index * index)));
    const auto H = h_function(nodes, a);
    const std::size_t n = nodes.size();

    // What has entered and comes up for the first time, per unit of irradiance on the surface.
    std::vector<double> mirror(n), first(n);
    for (std::size_t i = 0; i < n; ++i)
        mirror[i] = mirrored(nodes[i].mu, index);
    const double H_down = h_function(nodes, H, a, 1);
    const auto entered = [&](std::size_t j) { return (1 - mirror[j]) * index * index / pi; };
    for (std::size_t i = 0; i < n; ++i)
        first[i] = incidence == Incidence::Normal
                       ? (1 - mirrored(1, index)) * a * H[i] * H_down / (4 * pi * (nodes[i].mu + 1))
                       : a / 2 * H[i] * weighed(nodes, H, nodes[i].mu, entered);

    // All that comes up; each round adds what the surface has sent back once more.
    auto up = first;
    for (double change = 1; change > 1e-13;) {
        change = 0;
        auto next = first;
        for (std::size_t i = 0; i < n; ++i) {
            next[i] += a / 2 * H[i] * weighed(nodes, H, nodes[i].mu, [&](std::size_t j) {
                           return mirror[j] * up[j];
                       });
            change = std::max(change, std::abs(next[i] - up[i]));
        }
        up = std::move(next);
    }
    double leaving = 0;
    for (std::size_t i = 0; i < n; ++i)
        leaving += 2 * pi * nodes[i].weight * nodes[i].mu * (1 - mirror[i]) * up[i];
    return leaving;
}

} // namespace renderer
