// A mesh as it grows while a file is read: nothing enters that later code could trip over.
#include "renderer/geometry/mesh_building.h"

#include "renderer/contract.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace renderer::geometry {

Problem append_vertex(Mesh& mesh, glm::dvec3 position) {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(position[axis]))
            return fmt::format("vertex {} has the {} coordinate {}, expected a finite number",
                               mesh.positions.size(), "xyz"[axis], position[axis]);
    mesh.positions.push_back(position);
    return std::nullopt;
}

Problem append_polygon(Mesh& mesh, std::span<const double> corners, std::size_t vertices) {
    if (corners.size() < 3)
        return fmt::format("a face with {} corners, expected at least 3", corners.size());
    for (const double corner : corners)
        if (!(corner >= 0 && corner < static_cast<double>(vertices) &&
              corner == std::floor(corner)))
            return fmt::format(
                "a face with vertex {}, expected 0 or above and below {}, the number of vertices",
                corner, vertices);
    auto index = [&](std::size_t k) { return static_cast<std::uint32_t>(corners[k]); };
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        mesh.triangles.push_back({index(0), index(k), index(k + 1)});
    return std::nullopt;
}

Problem check_count(std::string_view things,
                    std::size_t count,
                    std::size_t least_bytes,
                    std::size_t bytes) {
    EXPECTS(least_bytes > 0);
    if (count > bytes / least_bytes)
        return fmt::format("{} {} are declared, but the {} bytes that follow hold at most {}; is "
                           "the file truncated?",
                           count, things, bytes, bytes / least_bytes);
    if (count > std::numeric_limits<std::uint32_t>::max())
        return fmt::format("{} {} are declared, expected fewer than 2^32", count, things);
    return std::nullopt;
}

} // namespace renderer::geometry
