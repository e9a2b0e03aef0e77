// Makes a mesh fit for tracing where that needs no guessing, and says what was done.
#include "renderer/geometry/mesh_repair.h"

#include "renderer/contract.h"
#include "renderer/geometry/openings.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace renderer::geometry {

namespace {

using Key = std::array<std::uint64_t, 3>;

struct KeyHash {
    std::size_t operator()(const Key& key) const {
        std::uint64_t hash = 0;
        for (const auto part :
             key) // the multiplier of splitmix64, which spreads neighbouring cells
            hash = (std::rotl(hash, 23) ^ part) * 0xbf58476d1ce4e5b9u;
        return hash ^ (hash >> 29);
    }
};

/// For every vertex the first vertex at the same place; -0 and 0 are the same.
std::vector<std::uint32_t> first_equal(const Mesh& mesh) {
    std::unordered_map<Key, std::uint32_t, KeyHash> first;
    first.reserve(mesh.positions.size());
    std::vector<std::uint32_t> result;
    for (const auto& p : mesh.positions) {
        const Key bits{std::bit_cast<std::uint64_t>(p.x + 0.0),
                       std::bit_cast<std::uint64_t>(p.y + 0.0),
                       std::bit_cast<std::uint64_t>(p.z + 0.0)};
        const auto index = static_cast<std::uint32_t>(result.size());
        result.push_back(first.try_emplace(bits, index).first->second);
    }
    return result;
}

/// For every vertex the first kept vertex within `distance`, itself if there is none: kept vertices
/// lie in a grid of cells as wide as the distance, so that 27 cells are all there is to search.
std::vector<std::uint32_t> first_within(const Mesh& mesh, double distance) {
    const auto sphere = bounding_sphere(mesh);
    std::unordered_map<Key, std::vector<std::uint32_t>, KeyHash> kept;
    std::vector<std::uint32_t> result;
    for (const auto& p : mesh.positions) {
        const auto own = static_cast<std::uint32_t>(result.size());
        const auto cell =
            glm::floor((p - sphere.centre + glm::dvec3(sphere.radius)) / distance) + 1.0;
        auto key = [&](int dx, int dy, int dz) {
            return Key{static_cast<std::uint64_t>(cell.x + dx),
                       static_cast<std::uint64_t>(cell.y + dy),
                       static_cast<std::uint64_t>(cell.z + dz)};
        };
        auto nearest = own;
        for (int neighbour = 0; neighbour < 27; ++neighbour) {
            const auto found =
                kept.find(key(neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1));
            if (found != kept.end())
                for (const auto candidate : found->second)
                    if (glm::distance(mesh.positions[candidate], p) <= distance)
                        nearest = std::min(nearest, candidate);
        }
        if (nearest == own)
            kept[key(0, 0, 0)].push_back(own);
        result.push_back(nearest);
    }
    return result;
}

void weld(Mesh& mesh, double within, Repairs& repairs) {
    const double distance = 2 * bounding_sphere(mesh).radius * within;
    const auto target = distance > 0 ? first_within(mesh, distance) : first_equal(mesh);
    for (auto& triangle : mesh.triangles)
        for (auto& corner : triangle)
            corner = target[corner];
    for (std::uint32_t v = 0; v < target.size(); ++v)
        repairs.welded_vertices += target[v] != v ? 1 : 0;
}

std::size_t drop_collapsed(Mesh& mesh) {
    return std::erase_if(mesh.triangles, [](const Triangle& t) {
        return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    });
}

std::size_t drop_duplicates(Mesh& mesh) {
    std::unordered_set<Key, KeyHash> seen;
    seen.reserve(mesh.triangles.size());
    return std::erase_if(mesh.triangles, [&](Triangle t) {
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        return !seen.insert({t[0], t[1], t[2]}).second;
    });
}

/// A needle may be what joins a long edge to the two short ones beside it: dropping it there would
/// open the surface.  All go, or all stay.
void drop_needles(Mesh& mesh, Repairs& repairs) {
    Mesh without = mesh;
    const auto needles =
        std::erase_if(without.triangles, [&](const Triangle& t) { return !has_area(mesh, t); });
    if (needles == 0)
        return;
    if (examine(without).unbalanced.count <= examine(mesh).unbalanced.count) {
        mesh = std::move(without);
        repairs.needle_triangles = needles;
    } else {
        repairs.needles_kept = needles;
    }
}

/// Drops vertices in no triangle; returns how many.
std::size_t drop_unused(Mesh& mesh) {
    std::vector<bool> is_used(mesh.positions.size(), false);
    for (const auto& triangle : mesh.triangles)
        for (const auto corner : triangle)
            is_used[corner] = true;
    std::vector<std::uint32_t> new_index(mesh.positions.size());
    std::uint32_t used = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (is_used[v]) {
            mesh.positions[used] = mesh.positions[v];
            new_index[v] = used++;
        }
    const auto dropped = mesh.positions.size() - used;
    mesh.positions.resize(used);
    for (auto& triangle : mesh.triangles)
        for (auto& corner : triangle)
            corner = new_index[corner];
    return dropped;
}

/// With openings covered; without, a volume depends on where the origin lies.
double enclosed_volume(const Mesh& mesh) {
    return signed_volume(cover_openings(mesh).mesh);
}

/// Thickness over diameter that is none: single precision puts the vertices of a flat sheet about
/// the origin up to 6e-8 of its diameter beside it.
constexpr double least_thickness = 1e-7;

/// Why a closed or covered surface has no inside, "" when it has one.
std::string why_empty(const PreparedMesh& prepared) {
    const auto& report = prepared.report;
    const double volume = enclosed_volume(prepared.mesh);
    const double diameter = glm::distance(report.low, report.high);
    const double least = least_thickness * diameter * report.area;
    if (!std::isfinite(volume) || !std::isfinite(least))
        return fmt::format("coordinates from {:.3g} to {:.3g} make a volume that is no number any "
                           "more; scale the model down in a mesh editor",
                           std::min({report.low.x, report.low.y, report.low.z}),
                           std::max({report.high.x, report.high.y, report.high.z}));
    if (volume > least)
        return {};
    if (volume < -least)
        return fmt::format("the surface faces inward: it encloses a volume of {:.6g}, expected "
                           "more than 0; turn its triangles in a mesh editor (flip the normals), "
                           "counter-clockwise seen from outside",
                           volume);
    return fmt::format("the surface is a sheet without an inside: it encloses a volume of {:.6g}, "
                       "expected more than {:.2g} for its diameter of {:.6g}; give it a thickness "
                       "in a mesh editor, or choose a closed model",
                       volume, least, diameter);
}

void flip(Mesh& mesh) {
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
}

} // namespace

PreparedMesh repair(Mesh mesh, const RepairOptions& options) {
    EXPECTS(options.weld_within >= 0 && options.weld_within <= 1e-3);
    PreparedMesh prepared;
    auto& repairs = prepared.repairs;
    // Vertices no triangle names are counted before welding, which leaves more of them behind.
    repairs.unused_vertices = drop_unused(mesh);
    weld(mesh, options.weld_within, repairs);
    repairs.collapsed_triangles = drop_collapsed(mesh);
    repairs.duplicate_triangles = drop_duplicates(mesh);
    drop_needles(mesh, repairs);
    drop_unused(mesh);
    prepared.report = examine(mesh);
    if (is_closed_and_oriented(prepared.report) && prepared.report.volume < 0) {
        flip(mesh);
        repairs.is_flipped = true;
        prepared.report = examine(mesh);
    }
    prepared.mesh = std::move(mesh);
    return prepared;
}

Expected<PreparedMesh> prepare(Mesh mesh, std::string_view name, const RepairOptions& options) {
    auto prepared = repair(std::move(mesh), options);
    const auto& report = prepared.report;
    if (report.triangles == 0)
        return tl::unexpected(
            fmt::format("{}: no triangle has an area, expected a solid body", name));
    const bool may_gape = is_oriented_but_for_openings(report);
    if (!is_closed_and_oriented(report) && !(may_gape && options.holes == Holes::ByWinding))
        return tl::unexpected(fmt::format(
            "{}: the surface is not closed and consistently oriented, so it has no inside "
            "to measure: {}; mend it in a mesh editor{}, or choose a closed model",
            name, describe_openings(report),
            may_gape ? ", take what it winds around for its inside (holes = \"winding\" in its "
                       "[[scene]], or --holes winding, where a command takes that)"
                     : ""));
    if (const auto why = why_empty(prepared); !why.empty())
        return tl::unexpected(fmt::format("{}: {}", name, why));
    return prepared;
}

std::vector<std::string> describe(const Repairs& repairs) {
    std::vector<std::string> lines;
    auto say = [&](std::size_t count, std::string_view things, std::string_view what) {
        if (count > 0)
            lines.push_back(fmt::format("{}: {} {}", things, count, what));
    };
    say(repairs.welded_vertices, "repeated vertices", "welded");
    say(repairs.collapsed_triangles, "collapsed triangles", "dropped");
    say(repairs.duplicate_triangles, "repeated triangles", "dropped");
    say(repairs.needle_triangles, "triangles without area", "dropped");
    say(repairs.needles_kept, "triangles without area",
        "kept, because they hold the surface together");
    say(repairs.unused_vertices, "vertices in no triangle", "dropped");
    if (repairs.is_flipped)
        lines.emplace_back("the surface faced inward (negative volume) and was turned outward");
    return lines;
}

} // namespace renderer::geometry
