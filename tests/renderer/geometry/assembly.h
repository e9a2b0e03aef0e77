// Putting test meshes together from bodies.
#pragma once

#include "renderer/geometry/mesh.h"

#include <utility>

namespace renderer::geometry {

/// `b`, moved by `by`, beside `a`; their vertices stay apart.
inline Mesh together(Mesh a, const Mesh& b, glm::dvec3 by = {}) {
    const auto offset = static_cast<std::uint32_t>(a.positions.size());
    for (const auto& p : b.positions)
        a.positions.push_back(p + by);
    for (const auto& [i, j, k] : b.triangles)
        a.triangles.push_back({i + offset, j + offset, k + offset});
    return a;
}

/// The same surface with inside and outside exchanged.
inline Mesh flipped(Mesh mesh) {
    for (auto& t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

inline Mesh moved(Mesh mesh, glm::dvec3 by) {
    for (auto& p : mesh.positions)
        p += by;
    return mesh;
}

} // namespace renderer::geometry
