// Sky and sun.
#include "renderer/reference/illumination.h"

#include "renderer/reference/phase.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace renderer::reference {

namespace {

constexpr double least_half_angle_degrees = 2;
constexpr double least_roughness = 0.1;

/// 1 - cos, without the cancellation.
double versine(Radians angle) {
    const double s = std::sin(angle.value / 2);
    return 2 * s * s;
}

} // namespace

double solid_angle(const Sun& sun) {
    return 2 * std::numbers::pi * versine(sun.half_angle);
}

bool is_toward(const Sun& sun, glm::dvec3 direction) {
    return sun.half_angle.value > 0 &&
           glm::dot(direction, sun.to_light) >= std::cos(sun.half_angle.value);
}

glm::dvec3 sample(const Sun& sun, double u1, double u2) {
    if (sun.half_angle.value == 0)
        return sun.to_light;
    return around(sun.to_light, 1 - u1 * versine(sun.half_angle), u2);
}

Expected<void> check_reachable(const Illumination& illumination, const Boundary& boundary) {
    const bool is_smooth = boundary.kind == BoundaryKind::Smooth;
    if (is_smooth && !illumination.lamps.empty())
        return tl::unexpected(std::string(
            "a smooth boundary near a lamp: no path finds a point through the refraction, expected "
            "a boundary that is matched or rough"));
    for (const auto& sun : illumination.suns) {
        const double degrees = sun.half_angle.value * 180 / std::numbers::pi;
        // 1e-9: an angle that was given in degrees and has been to radians and back
        if (is_smooth && degrees < least_half_angle_degrees - 1e-9)
            return tl::unexpected(fmt::format(
                "a smooth boundary under a sun of half-angle {:g} degrees: no path finds it "
                "through the refraction, expected at least {:g} degrees, or a boundary that is "
                "matched or rough",
                degrees, least_half_angle_degrees));
    }
    if (boundary.kind == BoundaryKind::Rough &&
        !(boundary.roughness >= least_roughness && boundary.roughness <= 1))
        return tl::unexpected(fmt::format("a rough boundary of roughness {:g}, expected {:g}..1; "
                                          "below, take a smooth one",
                                          boundary.roughness, least_roughness));
    return {};
}

} // namespace renderer::reference
