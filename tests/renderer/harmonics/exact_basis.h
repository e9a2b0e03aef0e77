// Spherical harmonics in extended precision: what double and float are held against.
#pragma once

#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace renderer::harmonics {

/// y(l, m) of the first `bands` bands at l(l+1)+m, in the direction that `v` points to, whatever
/// its length.  By normalised recurrences in z, 64 bits: good to 1e-19 times l^2.
inline std::vector<long double> exact_basis(int bands, glm::dvec3 v) {
    using Real = long double;
    const Real length = std::sqrt(static_cast<Real>(v.x) * v.x + static_cast<Real>(v.y) * v.y +
                                  static_cast<Real>(v.z) * v.z);
    const Real x = v.x / length, y = v.y / length, z = v.z / length;
    std::vector<Real> values(static_cast<std::size_t>(bands) * static_cast<std::size_t>(bands));
    Real c = 1, s = 0, sectoral = std::numbers::inv_sqrtpi_v<Real> / 2;
    for (int m = 0; m < bands; ++m) {
        if (m > 0) {
            sectoral *= std::sqrt((2 * Real(m) + 1) / (2 * Real(m)));
            const Real before = c;
            c = x * before - y * s;
            s = x * s + y * before;
        }
        const Real scale = m == 0 ? Real(1) : std::numbers::sqrt2_v<Real>;
        Real below = 0, p = sectoral;
        for (int l = m; l < bands; ++l) {
            if (l > m) {
                const Real ll = Real(l) * l, mm = Real(m) * m, kk = Real(l - 1) * (l - 1);
                const Real next = std::sqrt((4 * ll - 1) / (ll - mm)) *
                                  (z * p - std::sqrt((kk - mm) / (4 * kk - 1)) * below);
                below = p;
                p = next;
            }
            values[static_cast<std::size_t>(l * (l + 1) + m)] = scale * p * c;
            if (m > 0)
                values[static_cast<std::size_t>(l * (l + 1) - m)] = scale * p * s;
        }
    }
    return values;
}

} // namespace renderer::harmonics
