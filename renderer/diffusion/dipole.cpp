// The dipole's closed forms, and its spectrum on a sphere.
#include "renderer/diffusion/dipole.h"

#include "renderer/contract.h"
#include "renderer/diffusion/fresnel.h"
#include "renderer/harmonics/gauss_legendre.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace renderer::diffusion {

namespace {

Dipole dipole_of(double sigma_a, double sigma_s_reduced, double mismatch) {
    EXPECTS(sigma_a >= 0 && sigma_s_reduced >= 0);
    if (sigma_s_reduced == 0)
        return {};
    const double sigma_t = sigma_a + sigma_s_reduced;
    return {.alpha = sigma_s_reduced / sigma_t,
            .sigma_tr = std::sqrt(3 * sigma_a * sigma_t),
            .z_real = 1 / sigma_t,
            .z_virtual = (1 + 4 * mismatch / 3) / sigma_t};
}

/// One source's share of R_d times 4 pi / alpha, at the distance d from the source.
double source(double sigma_tr, double z, double d) {
    return z * (sigma_tr + 1 / d) * std::exp(-sigma_tr * d) / (d * d);
}

/// One source's share of the sphere's total times 2 / alpha; the longest chord ends at d_far.
double sphere_share(double sigma_tr, double z, double radius) {
    const double d_far = std::hypot(2 * radius, z);
    return std::exp(-sigma_tr * z) - z / d_far * std::exp(-sigma_tr * d_far);
}

/// One source's share of the eigenvalue times 2 / alpha: r dr = d dd, so with the distance d from
/// the source as variable the integrand is smooth on the scale of d itself, and every octave of it
/// takes the same few nodes.
double eigenvalue_share(double sigma_tr, double z, double radius, int l) {
    static const auto nodes = harmonics::gauss_legendre(32);
    const double d_far = std::hypot(2 * radius, z);
    double sum = 0;
    for (double begin = z; begin < d_far; begin *= 2) {
        const double end = std::min(2 * begin, d_far);
        for (const auto& [x, weight] : nodes) {
            const double d = begin + 0.5 * (1 + x) * (end - begin);
            const double cosine = 1 - (d - z) * (d + z) / (2 * radius * radius);
            sum += 0.5 * weight * (end - begin) * d * source(sigma_tr, z, d) *
                   harmonics::legendre_polynomial(l, cosine);
        }
    }
    return sum;
}

} // namespace

double boundary_mismatch(double eta) {
    const double f_dr = internal_diffuse_reflectance(eta);
    return (1 + f_dr) / (1 - f_dr);
}

std::array<Dipole, 3> dipoles(const Medium& medium) {
    const double mismatch = boundary_mismatch(medium.index);
    const auto& a = medium.sigma_a;
    const auto& s = medium.sigma_s_reduced;
    return {dipole_of(a.r, s.r, mismatch), dipole_of(a.g, s.g, mismatch),
            dipole_of(a.b, s.b, mismatch)};
}

double diffuse_reflectance(const Dipole& dipole, double r) {
    const double d_real = std::hypot(r, dipole.z_real);
    const double d_virtual = std::hypot(r, dipole.z_virtual);
    return dipole.alpha / (4 * std::numbers::pi) *
           (source(dipole.sigma_tr, dipole.z_real, d_real) +
            source(dipole.sigma_tr, dipole.z_virtual, d_virtual));
}

double plane_total(const Dipole& dipole) {
    return dipole.alpha / 2 *
           (std::exp(-dipole.sigma_tr * dipole.z_real) +
            std::exp(-dipole.sigma_tr * dipole.z_virtual));
}

double sphere_total(const Dipole& dipole, double radius) {
    EXPECTS(radius > 0);
    return dipole.alpha / 2 *
           (sphere_share(dipole.sigma_tr, dipole.z_real, radius) +
            sphere_share(dipole.sigma_tr, dipole.z_virtual, radius));
}

double sphere_eigenvalue(const Dipole& dipole, double radius, int l) {
    EXPECTS(radius > 0 && l >= 0);
    return dipole.alpha / 2 *
           (eigenvalue_share(dipole.sigma_tr, dipole.z_real, radius, l) +
            eigenvalue_share(dipole.sigma_tr, dipole.z_virtual, radius, l));
}

double mean_square_radius(const Dipole& dipole) {
    if (dipole.alpha == 0)
        return 0;
    if (dipole.sigma_tr == 0)
        return std::numeric_limits<double>::infinity();
    const double real = std::exp(-dipole.sigma_tr * dipole.z_real);
    const double mirrored = std::exp(-dipole.sigma_tr * dipole.z_virtual);
    return 2 / dipole.sigma_tr * (dipole.z_real * real + dipole.z_virtual * mirrored) /
           (real + mirrored);
}

} // namespace renderer::diffusion
