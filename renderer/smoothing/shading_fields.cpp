// Three right-hand sides for normals, nine for irradiance.
#include "renderer/smoothing/shading_fields.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/basis_blocks.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>

namespace renderer::smoothing {

namespace {

constexpr std::size_t irradiance_coefficients = irradiance_bands * irradiance_bands;

/// A vertex without triangles has no normal, and receives nothing.
bool is_direction(glm::dvec3 normal) {
    return glm::dot(normal, normal) > 0;
}

/// A_l y(l, m) in each normal's direction, 0 where there is none.
std::vector<double> irradiance(std::span<const glm::dvec3> normals) {
    using std::numbers::pi;
    constexpr std::array<double, irradiance_bands> A{pi, 2 * pi / 3, pi / 4};
    std::vector<glm::dvec3> directions(normals.begin(), normals.end());
    std::replace_if(directions.begin(), directions.end(), std::not_fn(is_direction),
                    glm::dvec3(0, 0, 1));
    std::vector<double> e(irradiance_coefficients * normals.size());
    harmonics::for_each_basis(irradiance_bands, directions, [&](std::size_t v, const auto& y) {
        if (!is_direction(normals[v]))
            return;
        for (int l = 0; l < irradiance_bands; ++l)
            for (int m = -l; m <= l; ++m) {
                const auto i = static_cast<std::size_t>(harmonics::flat_index(l, m));
                e[v * irradiance_coefficients + i] = A[static_cast<std::size_t>(l)] * y[i];
            }
    });
    return e;
}

} // namespace

double diffusion_time(double mean_square_radius, Millimetres diameter) {
    EXPECTS(mean_square_radius >= 0);
    EXPECTS(diameter.value > 0);
    const double widest = diameter.value / 8;
    return std::min(mean_square_radius / 4, widest * widest);
}

Expected<std::vector<glm::dvec3>>
smoothed_normals(SurfaceSmoother& smoother, double t, std::span<const glm::dvec3> normals) {
    std::vector<glm::dvec3> kept(normals.begin(), normals.end());
    if (t == 0)
        return kept; // not even made unit again, so that nothing of Phong's picture moves
    std::vector<double> values;
    values.reserve(3 * normals.size());
    for (const auto& normal : normals)
        values.insert(values.end(), {normal.x, normal.y, normal.z});
    const auto smooth = smoother.smooth(t, values, 3);
    if (!smooth)
        return tl::make_unexpected(smooth.error());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const glm::dvec3 mean((*smooth)[3 * i], (*smooth)[3 * i + 1], (*smooth)[3 * i + 2]);
        if (const double length = glm::length(mean); is_direction(kept[i]) && length >= 1e-3)
            kept[i] = mean / length;
    }
    return kept;
}

Expected<std::vector<double>>
smoothed_irradiance(SurfaceSmoother& smoother, double t, std::span<const glm::dvec3> normals) {
    return smoother.smooth(t, irradiance(normals), irradiance_coefficients);
}

} // namespace renderer::smoothing
