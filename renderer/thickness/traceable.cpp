// Orientation by volumes and winding numbers.
#include "renderer/thickness/traceable.h"

#include "renderer/contract.h"
#include "renderer/geometry/mesh_report.h"
#include "renderer/geometry/winding.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

namespace renderer::thickness {

namespace {

using geometry::Mesh;
using geometry::RayScene;

std::optional<std::string> what_is_not_finite(const Mesh& mesh) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const auto& p = mesh.positions[v];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            return fmt::format("vertex {} is at ({}, {}, {}), expected finite coordinates", v, p.x,
                               p.y, p.z);
    }
    return std::nullopt;
}

/// For every vertex, the smallest vertex it is connected with.
std::vector<std::uint32_t> component_of_vertices(const RayScene& scene) {
    std::vector<std::uint32_t> parent(scene.positions().size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t v) {
        while (parent[v] != v)
            v = parent[v] = parent[parent[v]];
        return v;
    };
    for (const auto& [a, b, c] : scene.triangles())
        for (const auto other : {b, c}) {
            const auto x = root(a), y = root(other);
            parent[std::max(x, y)] = std::min(x, y);
        }
    for (std::uint32_t v = 0; v < parent.size(); ++v)
        parent[v] = root(v);
    return parent;
}

} // namespace

Expected<geometry::CoveredMesh> covered_solid(const geometry::Mesh& mesh) {
    if (mesh.triangles.empty())
        return tl::unexpected<std::string>("the mesh has no triangles, expected a closed surface");
    for (const auto& triangle : mesh.triangles)
        for (const auto corner : triangle)
            EXPECTS(corner < mesh.positions.size());
    if (auto disappointment = what_is_not_finite(mesh))
        return tl::unexpected(std::move(*disappointment));
    if (const auto report = geometry::examine(mesh); !is_oriented_but_for_openings(report))
        return tl::unexpected(
            "the mesh is not consistently oriented: " + describe_openings(report) +
            "; expected neighbours that face the same way");
    auto covered = geometry::cover_openings(mesh);
    const double volume = geometry::signed_volume(covered.mesh);
    if (!(volume > 0))
        return tl::unexpected(fmt::format("the mesh encloses a volume of {:.6g}, expected a "
                                          "positive one (do its triangles face inward?)",
                                          volume));
    return covered;
}

Expected<void> check_components_face_outward(const geometry::RayScene& scene) {
    struct Component {
        double volume = 0;
        geometry::Triangle first{};
    };

    const auto positions = scene.positions();
    const auto component_of = component_of_vertices(scene);
    std::map<std::uint32_t, Component> components;
    for (const auto& triangle : scene.triangles()) {
        const auto [found, is_new] = components.try_emplace(component_of[triangle[0]]);
        auto& component = found->second;
        if (is_new)
            component.first = triangle;
        const glm::dvec3 a = positions[triangle[0]], b = positions[triangle[1]],
                         c = positions[triangle[2]];
        component.volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    for (const auto& [smallest_vertex, component] : components) {
        if (component.volume >= 0)
            continue;
        // The surface winds around its own vertices by a part of one: above 0 when the component is
        // a hole in something, below 0 when there is nothing around it.
        double winding = 0;
        for (const auto corner : component.first)
            winding += geometry::winding_number(positions, scene.triangles(), positions[corner]);
        if (winding < 0)
            return tl::unexpected(fmt::format(
                "the component of vertex {} faces inward and is not a cavity in another "
                "one, expected its triangles counter-clockwise seen from outside",
                smallest_vertex));
    }
    return {};
}

} // namespace renderer::thickness
