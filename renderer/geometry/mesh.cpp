// Measures of a triangle mesh: its bounding sphere, its volume, its vertex normals.
#include "renderer/geometry/mesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace renderer::geometry {

namespace {

/// Centre of the bounding box; the origin when there is no vertex.
glm::dvec3 box_centre(const Mesh& mesh) {
    if (mesh.positions.empty())
        return {};
    glm::dvec3 low = mesh.positions.front(), high = low;
    for (const auto& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return 0.5 * low + 0.5 * high;
}

/// Angle between two edges; atan2 keeps its digits where acos loses them, near 0 and pi.
double angle_between(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

} // namespace

BoundingSphere bounding_sphere(const Mesh& mesh) {
    BoundingSphere sphere{box_centre(mesh), 0};
    for (const auto& p : mesh.positions)
        sphere.radius = std::max(sphere.radius, glm::distance(p, sphere.centre));
    return sphere;
}

double signed_volume(const Mesh& mesh) {
    // Tetrahedra from the mesh's own centre: from a far origin they would cancel away the digits.
    const auto centre = box_centre(mesh);
    double six_volumes = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six_volumes += glm::dot(mesh.positions[a] - centre,
                                glm::cross(mesh.positions[b] - centre, mesh.positions[c] - centre));
    return six_volumes / 6;
}

std::vector<glm::dvec3> vertex_normals(const Mesh& mesh) {
    std::vector<glm::dvec3> normals(mesh.positions.size(), glm::dvec3(0));
    for (const auto& triangle : mesh.triangles) {
        const std::array corner{mesh.positions[triangle[0]], mesh.positions[triangle[1]],
                                mesh.positions[triangle[2]]};
        const auto doubled_area = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        const double length = glm::length(doubled_area);
        if (!(length > 0))
            continue;
        for (std::size_t k = 0; k < 3; ++k)
            normals[triangle[k]] +=
                angle_between(corner[(k + 1) % 3] - corner[k], corner[(k + 2) % 3] - corner[k]) /
                length * doubled_area;
    }
    for (auto& normal : normals)
        if (const double length = glm::length(normal); length > 0)
            normal /= length;
    return normals;
}

} // namespace renderer::geometry
