// Bodies whose shape, volume and thickness are known in closed form, as closed meshes.
#include "renderer/geometry/bodies.h"

#include "renderer/contract.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace renderer::geometry {

namespace {

Mesh icosahedron() {
    const double g = std::numbers::phi;
    Mesh mesh;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (auto& p : mesh.positions)
        p = glm::normalize(p);
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return mesh;
}

/// Splits every triangle of a unit sphere in four, with the new vertices on the sphere.
void split_on_unit_sphere(Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle_of_edge;
    auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [entry, is_new] = middle_of_edge.try_emplace(
            std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
        if (is_new)
            mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
        return entry->second;
    };
    std::vector<Triangle> split;
    split.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        split.insert(split.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(split);
}

/// Triangles that cover the surface of a block of nodes (0..cells.x) x (0..cells.y) x (0..cells.z),
/// facing outward; `position(node)` places each surface node in space.
template <class Position>
Mesh block_surface(glm::ivec3 cells, Position position) {
    Mesh mesh;
    std::map<std::array<int, 3>, std::uint32_t> index_of_node;
    auto index = [&](glm::ivec3 node) {
        const auto [entry, is_new] = index_of_node.try_emplace(
            {node.x, node.y, node.z}, static_cast<std::uint32_t>(mesh.positions.size()));
        if (is_new)
            mesh.positions.push_back(position(node));
        return entry->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const bool far_side : {false, true}) {
            // (u, v, axis) is right-handed, so u then v turns counter-clockwise seen from +axis.
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (int i = 0; i < cells[u]; ++i)
                for (int j = 0; j < cells[v]; ++j) {
                    auto corner = [&](int di, int dj) {
                        glm::ivec3 node;
                        node[axis] = far_side ? cells[axis] : 0;
                        node[u] = i + di;
                        node[v] = j + dj;
                        return index(node);
                    };
                    auto a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
                    if (!far_side)
                        std::swap(b, d);
                    mesh.triangles.push_back({a, b, c});
                    mesh.triangles.push_back({a, c, d});
                }
        }
    return mesh;
}

/// Where a rounded box's nodes lie along one axis: the point is flat[i] plus the rounding's radius
/// times a unit vector whose component along this axis is in proportion to slope[i].
struct RoundedAxis {
    std::vector<double> flat, slope;
};

RoundedAxis rounded_axis(double flat_half, double cell, int arc_cells) {
    RoundedAxis axis;
    // Equal angles from the face's middle to the edge where two faces meet at 45 degrees.
    auto slope = [&](int k) {
        return k == arc_cells ? 1.0 : std::tan(std::numbers::pi / 4 * k / arc_cells);
    };
    for (int k = arc_cells; k > 0; --k) {
        axis.flat.push_back(-flat_half);
        axis.slope.push_back(-slope(k));
    }
    const int flat_cells =
        flat_half > 0 ? std::max(1, static_cast<int>(std::lround(2 * flat_half / cell))) : 0;
    for (int k = 0; k <= flat_cells; ++k) {
        axis.flat.push_back(flat_cells == 0 ? 0 : flat_half * (2 * k - flat_cells) / flat_cells);
        axis.slope.push_back(0);
    }
    for (int k = 1; k <= arc_cells; ++k) {
        axis.flat.push_back(flat_half);
        axis.slope.push_back(slope(k));
    }
    return axis;
}

} // namespace

Mesh sphere(double radius, int subdivisions) {
    EXPECTS(radius > 0 && subdivisions >= 0 && subdivisions <= 9);
    auto mesh = icosahedron();
    for (int i = 0; i < subdivisions; ++i)
        split_on_unit_sphere(mesh);
    for (auto& p : mesh.positions)
        p *= radius;
    return mesh;
}

Mesh shell(double outer_radius, double inner_radius, int subdivisions) {
    EXPECTS(0 < inner_radius && inner_radius < outer_radius);
    auto mesh = sphere(outer_radius, subdivisions);
    const auto cavity = sphere(inner_radius, subdivisions);
    const auto offset = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), cavity.positions.begin(), cavity.positions.end());
    for (const auto& [a, b, c] : cavity.triangles)
        mesh.triangles.push_back({offset + a, offset + c, offset + b});
    return mesh;
}

Mesh torus(double major_radius, double minor_radius, int n_major, int n_minor) {
    EXPECTS(0 < minor_radius && minor_radius < major_radius && n_major >= 3 && n_minor >= 3);
    Mesh mesh;
    for (int i = 0; i < n_major; ++i)
        for (int j = 0; j < n_minor; ++j) {
            const double along = 2 * std::numbers::pi * i / n_major;
            const double around = 2 * std::numbers::pi * j / n_minor;
            const double from_axis = major_radius + minor_radius * std::cos(around);
            mesh.positions.emplace_back(from_axis * std::cos(along), from_axis * std::sin(along),
                                        minor_radius * std::sin(around));
        }
    auto node = [&](int i, int j) {
        return static_cast<std::uint32_t>((i % n_major) * n_minor + j % n_minor);
    };
    for (int i = 0; i < n_major; ++i)
        for (int j = 0; j < n_minor; ++j) {
            mesh.triangles.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
            mesh.triangles.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
        }
    return mesh;
}

Mesh slab(double width, double height, double thickness, int n) {
    EXPECTS(width > 0 && height > 0 && thickness > 0 && n >= 1);
    const glm::dvec3 size{width, height, thickness};
    const glm::ivec3 cells{n, n, 1};
    // (2k - n) / n is exactly -1 and 1 at the ends, so the faces lie exactly at half the size.
    return block_surface(cells, [&](glm::ivec3 node) {
        return 0.5 * size * glm::dvec3(2 * node - cells) / glm::dvec3(cells);
    });
}

Mesh rounded_box(glm::dvec3 half_extents, double radius, int n) {
    const double smallest = std::min({half_extents.x, half_extents.y, half_extents.z});
    const double largest = std::max({half_extents.x, half_extents.y, half_extents.z});
    EXPECTS(radius > 0 && radius <= smallest && n >= 1);
    const double cell = 2 * largest / n;
    const int arc_cells =
        std::max(1, static_cast<int>(std::lround(std::numbers::pi / 4 * radius / cell)));
    std::array<RoundedAxis, 3> axes;
    glm::ivec3 cells;
    for (int axis = 0; axis < 3; ++axis) {
        auto& nodes = axes[static_cast<std::size_t>(axis)];
        nodes = rounded_axis(half_extents[axis] - radius, cell, arc_cells);
        cells[axis] = static_cast<int>(nodes.flat.size()) - 1;
    }
    return block_surface(cells, [&](glm::ivec3 node) {
        glm::dvec3 flat, slope;
        for (int axis = 0; axis < 3; ++axis) {
            const auto& nodes = axes[static_cast<std::size_t>(axis)];
            flat[axis] = nodes.flat[static_cast<std::size_t>(node[axis])];
            slope[axis] = nodes.slope[static_cast<std::size_t>(node[axis])];
        }
        return flat + radius * glm::normalize(slope);
    });
}

} // namespace renderer::geometry
