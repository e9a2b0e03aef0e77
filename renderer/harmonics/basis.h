// Real spherical harmonics of a direction.  Conventions: docs/conventions.md#sh
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace renderer::harmonics {

/// Coefficients of `bands` bands: degrees 0..bands-1.
constexpr int coefficient_count(int bands) {
    return bands * bands;
}

/// Position of degree l, order m (-l..l) in a coefficient vector.
constexpr int flat_index(int l, int m) {
    return l * (l + 1) + m;
}

/// Evaluates every basis function of the first `bands` bands at `direction`.
/// Shapes: `out` has bands^2 elements; element l(l+1)+m holds y(l, m).
/// Units:  orthonormal over the sphere, no Condon-Shortley sign; `direction` is unit length.
/// Errors: EXPECTS on the size of `out`, bands >= 1 and on the length of `direction` (1e-6).
/// Up to ten bands by the polynomials of renderer/harmonics/basis_kernel.h, 2e-15 exact for five
/// and 1.2e-14 for ten; beyond them by recurrences.  For many directions: basis_blocks.h.
void evaluate(int bands, glm::dvec3 direction, std::span<double> out);

/// The same by normalised Legendre recurrences over degrees times (x + iy)^m, for any number of
/// bands: no factorials, no poles.  [Sloan2013]
void evaluate_by_recurrence(int bands, glm::dvec3 direction, std::span<double> out);

/// And from Legendre functions in angles and factorials: slow, for tests; bands <= 20.
void evaluate_by_definition(int bands, glm::dvec3 direction, std::span<double> out);

} // namespace renderer::harmonics
