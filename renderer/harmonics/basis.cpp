// Real spherical harmonics by polynomials, by normalised recurrences and by their definition.
#include "renderer/harmonics/basis.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis_kernels.h"
#include "renderer/harmonics/basis_polynomials.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace renderer::harmonics {

namespace {

bool is_unit(glm::dvec3 direction) {
    return std::abs(glm::length(direction) - 1.0) <= 1e-6;
}

std::size_t position(int l, int m) {
    return static_cast<std::size_t>(flat_index(l, m));
}

} // namespace

void evaluate(int bands, glm::dvec3 direction, std::span<double> out) {
    EXPECTS(bands >= 1);
    EXPECTS(out.size() == static_cast<std::size_t>(coefficient_count(bands)));
    EXPECTS(is_unit(direction));
    if (bands > most_unrolled_bands)
        return evaluate_by_recurrence(bands, direction, out);
    const double coordinates[] = {direction.x, direction.y, direction.z};
    single_kernels.in_double[bands - 1](coordinates, 1, polynomial_constants<double>(bands).data(),
                                        out.data());
}

void evaluate_by_recurrence(int bands, glm::dvec3 direction, std::span<double> out) {
    EXPECTS(bands >= 1);
    EXPECTS(out.size() == static_cast<std::size_t>(coefficient_count(bands)));
    EXPECTS(is_unit(direction));

    const double x = direction.x, y = direction.y, z = direction.z;
    double c = 1, s = 0;                          // C_m + i S_m = (x + iy)^m
    double p_mm = 0.5 * std::numbers::inv_sqrtpi; // P_00 = sqrt(1/4pi)
    for (int m = 0; m < bands; ++m) {
        if (m > 0) {
            p_mm *= std::sqrt((2.0 * m + 1.0) / (2.0 * m));
            const double c_before = c;
            c = x * c_before - y * s;
            s = x * s + y * c_before;
        }
        const double scale = m == 0 ? 1.0 : std::numbers::sqrt2;
        double p_before = 0, p = p_mm; // P_{l-1,m} and P_{l,m}, without the factor sin^m
        for (int l = m; l < bands; ++l) {
            if (l > m) {
                const double ll = 1.0 * l * l, mm = 1.0 * m * m, kk = (l - 1.0) * (l - 1.0);
                const double a = std::sqrt((4 * ll - 1) / (ll - mm));
                const double b = std::sqrt((kk - mm) / (4 * kk - 1)); // 0 at l = m + 1
                const double p_next = a * (z * p - b * p_before);
                p_before = p;
                p = p_next;
            }
            out[position(l, m)] = scale * p * c;
            if (m > 0)
                out[position(l, -m)] = scale * p * s;
        }
    }
}

void evaluate_by_definition(int bands, glm::dvec3 direction, std::span<double> out) {
    EXPECTS(bands >= 1 && bands <= 20);
    EXPECTS(out.size() == static_cast<std::size_t>(coefficient_count(bands)));
    EXPECTS(is_unit(direction));

    const double phi = std::atan2(direction.y, direction.x);
    const double cos_theta = std::clamp(direction.z, -1.0, 1.0);
    for (int l = 0; l < bands; ++l)
        for (int m = -l; m <= l; ++m) {
            const int order = std::abs(m);
            // The standard library's P_l^m has no Condon-Shortley sign, as ours has none.
            const double legendre = std::assoc_legendre(static_cast<unsigned>(l),
                                                        static_cast<unsigned>(order), cos_theta);
            const double normalisation =
                std::sqrt((2 * l + 1) / (4 * std::numbers::pi) *
                          (std::tgamma(l - order + 1) / std::tgamma(l + order + 1)));
            const double azimuth = m == 0  ? 1
                                   : m > 0 ? std::numbers::sqrt2 * std::cos(order * phi)
                                           : std::numbers::sqrt2 * std::sin(order * phi);
            out[position(l, m)] = normalisation * legendre * azimuth;
        }
}

} // namespace renderer::harmonics
