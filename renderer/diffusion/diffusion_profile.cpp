// The profile and its integrals.
#include "renderer/diffusion/diffusion_profile.h"

#include "renderer/contract.h"
#include "renderer/diffusion/dipole.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer::diffusion {

namespace {

// Both are integrals over the real line whose integrand is analytic around it: the trapezoid rule
// gains e^(-pi^2/h) in relative accuracy, 1e-17 at this step.
constexpr double step = 0.25;
constexpr double end = 40; // e^-40 is left of Ki1(0), less of all others

template <class Integrand>
double from_0_to_infinity(const Integrand& f) {
    double sum = f(0.0) / 2;
    for (double t = step; t <= end; t += step)
        sum += f(t);
    return sum * step;
}

double bessel_k0(double x) {
    return from_0_to_infinity([&](double t) { return std::exp(-x * std::cosh(t)); });
}

/// Bickley's function: the integral of K0 from x on.
double bickley_1(double x) {
    return from_0_to_infinity([&](double t) { return std::exp(-x * std::cosh(t)) / std::cosh(t); });
}

} // namespace

glm::dvec3 diffusion_length(const Medium& medium) {
    const auto dipoles = diffusion::dipoles(medium);
    const auto length = [](const diffusion::Dipole& dipole, double sigma_t) {
        const double A = diffusion::plane_total(dipole);
        return sigma_t == 0 ? 0.0 : 1 / sigma_t / (1.9 - A + 3.5 * (A - 0.8) * (A - 0.8));
    };
    const auto &a = medium.sigma_a, &s = medium.sigma_s_reduced;
    return {length(dipoles[0], a.r + s.r), length(dipoles[1], a.g + s.g),
            length(dipoles[2], a.b + s.b)};
}

double line_profile(double x, double d) {
    EXPECTS(x > 0 && d > 0);
    return (bessel_k0(x / d) + bessel_k0(x / (3 * d))) / (4 * std::numbers::pi * d);
}

double line_profile_beyond(double x, double d) {
    EXPECTS(x >= 0 && d >= 0);
    if (x == 0)
        return 0.5;
    if (d == 0)
        return 0;
    return (bickley_1(x / d) + 3 * bickley_1(x / (3 * d))) / (4 * std::numbers::pi);
}

std::vector<DiffusionTap> diffusion_taps(const glm::dvec3& d, int count) {
    EXPECTS(count >= 3 && count % 2 == 1);
    // Beyond 12 d lies 1/4 % of the profile on either side.
    const double reach = 12 * std::max({d.x, d.y, d.z});
    const int side = count / 2;
    const auto offset = [&](int i) {
        const double part = static_cast<double>(i) / side;
        return reach * part * std::abs(part);
    };
    const auto beyond = [&](int i) { // the half way from tap i to the next
        const double x = (offset(i) + offset(i + 1)) / 2;
        return glm::dvec3(line_profile_beyond(x, d.x), line_profile_beyond(x, d.y),
                          line_profile_beyond(x, d.z));
    };
    std::vector<DiffusionTap> taps(static_cast<std::size_t>(count));
    glm::dvec3 left_over(0.5); // from the tap's inner boundary on
    for (int i = 0; i <= side; ++i) {
        const auto outside = i == side ? glm::dvec3(0) : beyond(i);
        const auto weight = i == 0 ? 2.0 * (left_over - outside) : left_over - outside;
        taps[static_cast<std::size_t>(side + i)] = {offset(i), weight};
        taps[static_cast<std::size_t>(side - i)] = {-offset(i), weight};
        left_over = outside;
    }
    return taps;
}

} // namespace renderer::diffusion
