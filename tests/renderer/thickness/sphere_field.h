// The thickness field of the unit sphere in closed form, at even vertices.
#pragma once

#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/directions.h"
#include "renderer/thickness/thickness_field.h"

#include <array>
#include <cmath>
#include <numbers>

namespace renderer::thickness {

/// Zonal about each normal with the coefficients of 2 max(0, -x): methods page, SHSS, truncation.
/// Vertices lie in the directions of fibonacci_directions(vertices, 3).
inline ThicknessField sphere_field(int bands, int vertices) {
    constexpr std::array<double, 6> zonal{1.7724539, -2.0466534, 0.9908318, 0, -0.2215567, 0};
    ThicknessField field;
    field.bands = field.options.bands = bands;
    field.energy.assign(static_cast<std::size_t>(vertices), 8 * std::numbers::pi / 3);
    field.d_n = 2;
    std::vector<double> y(static_cast<std::size_t>(harmonics::coefficient_count(bands)));
    for (const auto& normal : harmonics::fibonacci_directions(vertices, 3).directions) {
        harmonics::evaluate(bands, normal, y);
        for (int l = 0; l < bands; ++l)
            for (int m = -l; m <= l; ++m)
                field.coefficients.push_back(
                    static_cast<float>(zonal[static_cast<std::size_t>(l)] *
                                       std::sqrt(4 * std::numbers::pi / (2 * l + 1)) *
                                       y[static_cast<std::size_t>(harmonics::flat_index(l, m))]));
    }
    return field;
}

} // namespace renderer::thickness
