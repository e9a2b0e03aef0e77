// Each triangle gives half the cotangent of a corner to the edge across from it.
#include "renderer/smoothing/cotangent_laplacian.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace renderer::smoothing {

namespace {

/// Halves of cotangents by edge, one for each triangle at it.
std::vector<WeightedEdge> half_cotangents(const geometry::Mesh& mesh, std::vector<double>& areas) {
    std::vector<WeightedEdge> halves;
    halves.reserve(3 * mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        const auto corner = [&](std::size_t k) { return mesh.positions[triangle[k % 3]]; };
        const double doubled_area =
            glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
        if (!(doubled_area > 0))
            continue;
        for (std::size_t k = 0; k < 3; ++k) {
            areas[triangle[k]] += doubled_area / 6;
            const double cosine = glm::dot(corner(k + 1) - corner(k), corner(k + 2) - corner(k));
            const auto [low, high] = std::minmax(triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
            halves.push_back({{low, high}, cosine / doubled_area / 2});
        }
    }
    return halves;
}

} // namespace

CotangentLaplacian cotangent_laplacian(const geometry::Mesh& mesh) {
    CotangentLaplacian laplacian;
    laplacian.areas.assign(mesh.positions.size(), 0);
    auto halves = half_cotangents(mesh, laplacian.areas);
    // Stable, so that sums do not depend on the sorting's whims.
    std::stable_sort(halves.begin(), halves.end(),
                     [](const auto& a, const auto& b) { return a.ends < b.ends; });
    for (std::size_t i = 0; i < halves.size();) {
        WeightedEdge edge{halves[i].ends, 0};
        for (; i < halves.size() && halves[i].ends == edge.ends; ++i)
            edge.weight += halves[i].weight;
        laplacian.clamped += edge.weight < 0 ? 1 : 0;
        edge.weight = std::max(edge.weight, 0.0);
        laplacian.edges.push_back(edge);
    }
    return laplacian;
}

} // namespace renderer::smoothing
