// Generalised winding number by plain summation.
#include "renderer/geometry/winding.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace renderer::geometry {

double winding_number(std::span<const glm::vec3> positions,
                      std::span<const Triangle> triangles,
                      glm::dvec3 point) {
    double half_solid_angles = 0;
    for (const auto& [i, j, k] : triangles) {
        const glm::dvec3 a = glm::dvec3(positions[i]) - point, b = glm::dvec3(positions[j]) - point,
                         c = glm::dvec3(positions[k]) - point;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        // tan(solid angle / 2), negative denominators included.  [VanOosterom1983, eq. 8]
        const double numerator = glm::dot(a, glm::cross(b, c));
        const double denominator =
            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
        half_solid_angles += std::atan2(numerator, denominator);
    }
    return half_solid_angles / (2 * std::numbers::pi);
}

} // namespace renderer::geometry
