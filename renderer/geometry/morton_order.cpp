// Morton codes of 21 bits per coordinate.
#include "renderer/geometry/morton_order.h"

#include <algorithm>
#include <utility>

namespace renderer::geometry {

namespace {

/// Inserts two zero bits before each of the lowest 21 bits.
std::uint64_t spread(std::uint64_t x) {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    x = (x | x << 2) & 0x1249249249249249;
    return x;
}

std::uint64_t cell(float coordinate) {
    return static_cast<std::uint64_t>(std::clamp(coordinate + 0.5, 0.0, 1.0) * 0x1fffff);
}

} // namespace

std::vector<std::uint32_t> morton_order(std::span<const glm::vec3> positions) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        const auto& p = positions[v];
        keyed.emplace_back(spread(cell(p.x)) | spread(cell(p.y)) << 1 | spread(cell(p.z)) << 2, v);
    }
    std::sort(keyed.begin(), keyed.end());
    std::vector<std::uint32_t> order;
    for (const auto& [code, v] : keyed)
        order.push_back(v);
    return order;
}

Mesh along_morton_curve(const Mesh& mesh) {
    const auto bounds = bounding_sphere(mesh);
    const double diameter = bounds.radius > 0 ? 2 * bounds.radius : 1; // all in one point
    std::vector<glm::vec3> unit;
    for (const auto& position : mesh.positions)
        unit.emplace_back((position - bounds.centre) / diameter);
    Mesh moved;
    std::vector<std::uint32_t> place(mesh.positions.size());
    for (const auto v : morton_order(unit)) {
        place[v] = static_cast<std::uint32_t>(moved.positions.size());
        moved.positions.push_back(mesh.positions[v]);
    }
    for (const auto& [a, b, c] : mesh.triangles)
        moved.triangles.push_back({place[a], place[b], place[c]});
    return moved;
}

} // namespace renderer::geometry
