// Fresnel and Snell.
#include "renderer/reference/boundary.h"

#include "renderer/contract.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace renderer::reference {

std::optional<BoundaryKind> boundary_kind(std::string_view name) {
    for (const auto kind : {BoundaryKind::Matched, BoundaryKind::Smooth, BoundaryKind::Rough})
        if (name == name_of(kind))
            return kind;
    return std::nullopt;
}

std::string_view name_of(BoundaryKind kind) {
    switch (kind) {
    case BoundaryKind::Smooth:
        return "smooth";
    case BoundaryKind::Rough:
        return "rough";
    case BoundaryKind::Matched:
        break;
    }
    return "matched";
}

double fresnel(double cosine, double index) {
    EXPECTS(index > 0);
    if (index == 1)
        return 0;
    const double c = std::clamp(cosine, 0.0, 1.0);
    // 1 - (1 - c^2) / index^2, with all its digits for an index near 1
    const double behind_squared = ((index - 1) * (index + 1) + c * c) / (index * index);
    if (behind_squared <= 0)
        return 1;
    const double behind = std::sqrt(behind_squared);
    const double across = (c - index * behind) / (c + index * behind);
    const double along = (index * c - behind) / (index * c + behind);
    return 0.5 * (across * across + along * along);
}

double diffuse_fresnel(double index) {
    // Midpoints in cos^2: the integrand is bounded, with a root's kink at the critical angle.
    constexpr int n = 200000;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        sum += fresnel(std::sqrt((i + 0.5) / n), index);
    return sum / n;
}

std::optional<glm::dvec3> refracted(glm::dvec3 direction, glm::dvec3 normal, double index) {
    if (index == 1)
        return direction;
    const double c = -glm::dot(direction, normal);
    // 1 - (1 - c^2) / index^2, with all its digits for an index near 1
    const double behind_squared = ((index - 1) * (index + 1) + c * c) / (index * index);
    if (behind_squared <= 0)
        return std::nullopt;
    return glm::normalize(direction / index + (c / index - std::sqrt(behind_squared)) * normal);
}

glm::dvec3 reflected(glm::dvec3 direction, glm::dvec3 normal) {
    return direction - 2 * glm::dot(direction, normal) * normal;
}

} // namespace renderer::reference
