// Three right-hand sides for normals, nine for irradiance.
#include "renderer/smoothing/shading_fields.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <numbers>

namespace renderer::smoothing {

namespace {

constexpr std::size_t irradiance_coefficients = irradiance_bands * irradiance_bands;

/// A vertex without triangles has no normal, and receives nothing.
bool is_direction(glm::dvec3 normal) {
    return glm::dot(normal, normal) > 0;
}

std::array<double, irradiance_coefficients> irradiance(glm::dvec3 normal) {
    using std::numbers::pi;
    constexpr std::array<double, irradiance_bands> A{pi, 2 * pi / 3, pi / 4};
    std::array<double, irradiance_coefficients> e{};
    if (!is_direction(normal))
        return e;
    harmonics::evaluate(irradiance_bands, normal, e);
    for (int l = 0; l < irradiance_bands; ++l)
        for (int m = -l; m <= l; ++m)
            e[static_cast<std::size_t>(harmonics::flat_index(l, m))] *=
                A[static_cast<std::size_t>(l)];
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
    std::vector<double> values;
    values.reserve(irradiance_coefficients * normals.size());
    for (const auto& normal : normals) {
        const auto e = irradiance(normal);
        values.insert(values.end(), e.begin(), e.end());
    }
    return smoother.smooth(t, values, irradiance_coefficients);
}

} // namespace renderer::smoothing
