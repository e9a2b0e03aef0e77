// Thirds of triangle areas, rounded to integers.
#include "renderer/thickness/surface_shares.h"

#include "renderer/contract.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numeric>

namespace renderer::thickness {

std::vector<std::uint64_t> surface_shares(const geometry::Mesh& mesh) {
    std::vector<double> areas(mesh.positions.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions[a];
        const double area = glm::length(glm::cross(mesh.positions[b] - p, mesh.positions[c] - p));
        for (const auto corner : {a, b, c})
            areas[corner] += area;
    }
    const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
    EXPECTS(total > 0);
    std::vector<std::uint64_t> shares;
    for (const double area : areas)
        shares.push_back(static_cast<std::uint64_t>(std::llround(area / total * 0x1p40)));
    return shares;
}

} // namespace renderer::thickness
