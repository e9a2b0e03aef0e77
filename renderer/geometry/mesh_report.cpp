// What a mesh is like: how its edges meet, how many pieces it has, what it encloses.
#include "renderer/geometry/mesh_report.h"

#include "renderer/geometry/disjoint_sets.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <span>
#include <tuple>

namespace renderer::geometry {

namespace {

/// One side of an edge: triangle `triangle` passes it from `low` to `high`, or the other way.
struct Passage {
    std::uint32_t low = 0, high = 0, triangle = 0;
    std::uint8_t corner = 0; ///< of the triangle, where the passage starts
    bool is_forward = false;
};

/// All passages, those of one edge side by side.  Collapsed edges are no edges.
std::vector<Passage> sorted_passages(const Mesh& mesh) {
    std::vector<Passage> passages;
    passages.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint8_t k = 0; k < 3; ++k) {
            const auto a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            if (a != b)
                passages.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
        }
    std::sort(passages.begin(), passages.end(), [](const Passage& a, const Passage& b) {
        return std::tie(a.low, a.high, a.triangle, a.corner) <
               std::tie(b.low, b.high, b.triangle, b.corner);
    });
    return passages;
}

/// Calls `visit` with the passages of each edge in turn.
template <class Visit>
void for_each_edge(std::span<const Passage> passages, Visit visit) {
    while (!passages.empty()) {
        const auto& first = passages.front();
        std::size_t count = 1;
        while (count < passages.size() && passages[count].low == first.low &&
               passages[count].high == first.high)
            ++count;
        visit(passages.first(count));
        passages = passages.subspan(count);
    }
}

void note(EdgesFound& found, const Mesh& mesh, const Passage& edge) {
    if (found.count++ == 0)
        found.first = {mesh.positions[edge.low], mesh.positions[edge.high]};
}

/// Classifies the edges; returns how many there are.
std::size_t examine_edges(const Mesh& mesh, std::span<const Passage> passages, MeshReport& report) {
    std::size_t edges = 0;
    for_each_edge(passages, [&](std::span<const Passage> edge) {
        ++edges;
        const auto forward = static_cast<std::size_t>(
            std::count_if(edge.begin(), edge.end(), [](const auto& p) { return p.is_forward; }));
        const bool is_balanced = 2 * forward == edge.size();
        if (edge.size() == 1)
            note(report.boundary, mesh, edge[0]);
        if (edge.size() == 2 && !is_balanced)
            note(report.inconsistent, mesh, edge[0]);
        if (edge.size() > 2)
            note(report.non_manifold, mesh, edge[0]);
        if (!is_balanced)
            note(report.unbalanced, mesh, edge[0]);
    });
    return edges;
}

/// Vertices around which the triangles do not form one fan: corners are joined across edges of two
/// triangles, and a vertex left with several sets of corners is where sheets only touch.
std::size_t count_pinched(const Mesh& mesh, std::span<const Passage> passages) {
    auto corner_at = [&](std::uint32_t triangle, std::uint32_t vertex) {
        const auto& t = mesh.triangles[triangle];
        return 3 * triangle + (t[0] == vertex ? 0u : t[1] == vertex ? 1u : 2u);
    };
    DisjointSets corners(3 * mesh.triangles.size());
    for_each_edge(passages, [&](std::span<const Passage> edge) {
        if (edge.size() == 2)
            for (const auto vertex : {edge[0].low, edge[0].high})
                corners.join(corner_at(edge[0].triangle, vertex),
                             corner_at(edge[1].triangle, vertex));
    });
    std::vector<std::size_t> fans(mesh.positions.size(), 0);
    for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner)
        if (corners.find(corner) == corner)
            ++fans[mesh.triangles[corner / 3][corner % 3]];
    return static_cast<std::size_t>(
        std::count_if(fans.begin(), fans.end(), [](std::size_t n) { return n > 1; }));
}

std::size_t count_duplicates(const Mesh& mesh) {
    auto sorted = mesh.triangles;
    for (auto& t : sorted)
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(sorted.begin(), sorted.end());
    const auto unique = std::unique(sorted.begin(), sorted.end()) - sorted.begin();
    return sorted.size() - static_cast<std::size_t>(unique);
}

void examine_pieces(const Mesh& mesh, MeshReport& report) {
    DisjointSets pieces(mesh.positions.size());
    std::vector<bool> is_used(mesh.positions.size(), false);
    for (const auto& [a, b, c] : mesh.triangles) {
        pieces.join(a, b);
        pieces.join(b, c);
        is_used[a] = is_used[b] = is_used[c] = true;
    }
    const auto used = static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), true));
    report.unused_vertices = mesh.positions.size() - used;
    std::map<std::uint32_t, double> volume_of_piece;
    const auto centre = 0.5 * report.low + 0.5 * report.high;
    for (const auto& [a, b, c] : mesh.triangles)
        volume_of_piece[pieces.find(a)] +=
            glm::dot(mesh.positions[a] - centre,
                     glm::cross(mesh.positions[b] - centre, mesh.positions[c] - centre));
    report.components = volume_of_piece.size();
    if (is_closed_and_oriented(report))
        report.cavities = static_cast<std::size_t>(
            std::count_if(volume_of_piece.begin(), volume_of_piece.end(),
                          [](const auto& piece) { return piece.second < 0; }));
}

void examine_size(const Mesh& mesh, MeshReport& report) {
    if (!mesh.positions.empty())
        report.low = report.high = mesh.positions.front();
    for (const auto& p : mesh.positions) {
        report.low = glm::min(report.low, p);
        report.high = glm::max(report.high, p);
    }
    for (const auto& triangle : mesh.triangles) {
        const auto& a = mesh.positions[triangle[0]];
        report.area += 0.5 * glm::length(glm::cross(mesh.positions[triangle[1]] - a,
                                                    mesh.positions[triangle[2]] - a));
        report.zero_area += has_area(mesh, triangle) ? 0 : 1;
    }
    report.volume = signed_volume(mesh);
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string at(glm::dvec3 p) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z);
}

std::string edges_text(const EdgesFound& edges, std::string_view one, std::string_view many) {
    return fmt::format("{}, the first from {} to {}", counted(edges.count, one, many),
                       at(edges.first[0]), at(edges.first[1]));
}

std::string shape_text(const MeshReport& report) {
    auto text = counted(report.components, "component", "components");
    if (report.cavities > 0)
        text += fmt::format(", {} of them facing inward", report.cavities);
    if (!is_closed_and_oriented(report))
        return text + "; not closed and consistently oriented";
    text += "; closed and consistently oriented";
    return report.genus ? fmt::format("{}, genus {}", text, *report.genus) : text;
}

} // namespace

bool has_area(const Mesh& mesh, const Triangle& triangle) {
    const auto &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]],
               &c = mesh.positions[triangle[2]];
    const double longest =
        std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    constexpr double least_height = 1e-12; // of the longest edge
    return glm::length(glm::cross(b - a, c - a)) > least_height * longest * longest;
}

bool is_closed_and_oriented(const MeshReport& report) {
    return report.triangles > 0 && report.unbalanced.count == 0;
}

bool is_oriented_but_for_openings(const MeshReport& report) {
    return report.triangles > 0 && report.unbalanced.count == report.boundary.count;
}

MeshReport examine(const Mesh& mesh) {
    MeshReport report;
    report.vertices = mesh.positions.size();
    report.triangles = mesh.triangles.size();
    const auto passages = sorted_passages(mesh);
    const auto edges = examine_edges(mesh, passages, report);
    report.pinched_vertices = count_pinched(mesh, passages);
    report.duplicate = count_duplicates(mesh);
    examine_size(mesh, report);
    examine_pieces(mesh, report);
    if (is_closed_and_oriented(report) && report.non_manifold.count == 0 &&
        report.pinched_vertices == 0) {
        const auto used = static_cast<long>(report.vertices - report.unused_vertices);
        const auto euler = used - static_cast<long>(edges) + static_cast<long>(report.triangles);
        report.genus = static_cast<long>(report.components) - euler / 2;
    }
    return report;
}

std::string describe_openings(const MeshReport& report) {
    std::vector<std::string> openings;
    if (report.boundary.count > 0)
        openings.push_back(edges_text(report.boundary, "boundary edge", "boundary edges"));
    if (report.inconsistent.count > 0)
        openings.push_back(edges_text(report.inconsistent,
                                      "edge whose two triangles face opposite ways",
                                      "edges whose two triangles face opposite ways"));
    if (report.non_manifold.count > 0)
        openings.push_back(edges_text(report.non_manifold, "edge with more than two triangles",
                                      "edges with more than two triangles"));
    return fmt::format("{}", fmt::join(openings, "; "));
}

std::vector<std::string> describe(const MeshReport& report) {
    std::vector<std::string> lines{counted(report.vertices, "vertex", "vertices") + ", " +
                                       counted(report.triangles, "triangle", "triangles"),
                                   shape_text(report)};
    const auto size = report.high - report.low;
    lines.push_back(
        fmt::format("size {:.6g} x {:.6g} x {:.6g}, area {:.6g}, volume {:.6g} (model units)",
                    size.x, size.y, size.z, report.area, report.volume));
    if (const auto openings = describe_openings(report); !openings.empty())
        lines.push_back(openings);
    if (report.pinched_vertices > 0)
        lines.push_back(counted(report.pinched_vertices,
                                "vertex where sheets touch without a common edge",
                                "vertices where sheets touch without a common edge"));
    if (report.zero_area > 0)
        lines.push_back(counted(report.zero_area, "triangle", "triangles") + " without area");
    if (report.duplicate > 0)
        lines.push_back(counted(report.duplicate, "triangle repeats", "triangles repeat") +
                        " another");
    if (report.unused_vertices > 0)
        lines.push_back(counted(report.unused_vertices, "vertex", "vertices") + " in no triangle");
    return lines;
}

} // namespace renderer::geometry
