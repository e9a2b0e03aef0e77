// A triangle mesh as a value, and what can be asked of its shape.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace renderer::geometry {

using Triangle = std::array<std::uint32_t, 3>; ///< counter-clockwise seen from outside

/// Positions in model coordinates, double so that far-away models keep their digits.
struct Mesh {
    std::vector<glm::dvec3> positions;
    std::vector<Triangle> triangles;
};

struct BoundingSphere {
    glm::dvec3 centre{};
    double radius = 0;
};

/// Sphere around the bounding box's centre through the farthest vertex.  Model units.
BoundingSphere bounding_sphere(const Mesh& mesh);

/// Signed volume: positive when triangles face outward.  Model units cubed.
double signed_volume(const Mesh& mesh);

/// Unit vertex normals, angle-weighted; (0,0,0) for a vertex without triangles of positive area.
std::vector<glm::dvec3> vertex_normals(const Mesh& mesh);

} // namespace renderer::geometry
