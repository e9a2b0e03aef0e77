// What a mesh is like: how its edges meet, how many pieces it has, what it encloses.
#pragma once

#include "renderer/geometry/mesh.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace renderer::geometry {

/// Edges of one kind: how many there are, and the ends of the first one (in the order of vertex
/// indices), in model coordinates.
struct EdgesFound {
    std::size_t count = 0;
    std::array<glm::dvec3, 2> first{};
};

/// Vertices are told apart by index, so weld first (renderer/geometry/mesh_repair.h) where a file
/// repeats them.
struct MeshReport {
    std::size_t vertices = 0, triangles = 0;
    std::size_t components = 0;       ///< pieces of triangles that hang together by vertices
    std::size_t cavities = 0;         ///< components that face inward; 0 unless closed
    std::size_t unused_vertices = 0;  ///< in no triangle
    std::size_t zero_area = 0;        ///< triangles without area, see `has_area`
    std::size_t duplicate = 0;        ///< triangles that repeat another, facing the same way
    std::size_t pinched_vertices = 0; ///< where sheets touch that share no edge there
    EdgesFound boundary;              ///< one triangle
    EdgesFound inconsistent;          ///< two triangles that face opposite ways
    EdgesFound non_manifold;          ///< more than two triangles
    EdgesFound unbalanced;     ///< not passed as often one way as the other: here rays lose count
    double volume = 0;         ///< signed, model units cubed; meaningful where closed
    double area = 0;           ///< model units squared
    glm::dvec3 low{}, high{};  ///< of the bounding box
    std::optional<long> genus; ///< handles of all components; of a closed manifold only
};

/// Looks at every vertex, edge and triangle once; sorts the edges.  Indices in range.
MeshReport examine(const Mesh& mesh);

/// Every edge is passed as often one way as the other, so that along any ray every way in has its
/// way out: what thickness needs.  Edges with more than two triangles may be among them.
bool is_closed_and_oriented(const MeshReport& report);

/// Every edge that is not so has one triangle: then the edges that are left are the rims of
/// openings, and a surface that winds around most of what it holds still has an inside
/// (openings.h).
bool is_oriented_but_for_openings(const MeshReport& report);

/// Whether a triangle's height is more than 1e-12 of its longest edge.  Less is rounding: doubles
/// near the edge's length differ by 1e-16 of it.
bool has_area(const Mesh& mesh, const Triangle& triangle);

/// The report as a person reads it, a few short lines.
std::vector<std::string> describe(const MeshReport& report);

/// "3 boundary edges, the first from (0, 0, 0) to (1, 0, 0)" for every kind of edge that is not
/// shared by two triangles facing the same way, joined by "; "; empty if there are none.
std::string describe_openings(const MeshReport& report);

} // namespace renderer::geometry
