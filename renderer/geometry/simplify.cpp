// OpenMesh's half-edge collapses, whose checks keep a closed manifold one; looked at afterwards all
// the same.
#include "renderer/geometry/simplify.h"

#include "renderer/geometry/mesh_report.h"

#include <fmt/format.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModAspectRatioT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace renderer::geometry {

namespace {

struct InDoubles : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};

using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<InDoubles>;
using Decimater = OpenMesh::Decimater::DecimaterT<HalfEdges>;
using Quadrics = OpenMesh::Decimater::ModQuadricT<HalfEdges>;
using NoNeedles = OpenMesh::Decimater::ModAspectRatioT<HalfEdges>;
using NoFlips = OpenMesh::Decimater::ModNormalFlippingT<HalfEdges>;

constexpr float longest_needle = 100; // longest edge over height that a collapse may bring

bool is_closed_manifold(const MeshReport& report) {
    return is_closed_and_oriented(report) && report.boundary.count == 0 &&
           report.non_manifold.count == 0 && report.inconsistent.count == 0 &&
           report.pinched_vertices == 0;
}

std::string what_is_wrong(const MeshReport& report) {
    auto words = describe_openings(report);
    if (words.empty())
        words = fmt::format("{} vertices where sheets touch", report.pinched_vertices);
    return "only a closed manifold can be simplified and stay one, but there are " + words;
}

bool has_kept_its_shape(const MeshReport& before, const MeshReport& after) {
    return is_closed_manifold(after) && after.components == before.components &&
           after.cavities == before.cavities && after.genus == before.genus &&
           after.zero_area <= before.zero_area && after.duplicate == 0 && after.volume > 0;
}

} // namespace

struct Simplifier::State {
    explicit State(const Mesh& original)
        : positions(original.positions), before(examine(original)), decimater(mesh) {}

    bool build(const std::vector<Triangle>& triangles);
    Mesh current() const;

    std::vector<glm::dvec3> positions; ///< of the original
    MeshReport before;
    HalfEdges mesh; ///< in the unit sphere: squares of far-away coordinates would cost digits
    OpenMesh::VPropHandleT<std::uint32_t> index; ///< in the original
    Decimater decimater;
};

bool Simplifier::State::build(const std::vector<Triangle>& triangles) {
    const auto sphere = bounding_sphere({positions, {}});
    mesh.add_property(index);
    std::vector<HalfEdges::VertexHandle> handles;
    for (const auto& position : positions) {
        const auto p = (position - sphere.centre) / sphere.radius;
        handles.push_back(mesh.add_vertex({p.x, p.y, p.z}));
        mesh.property(index, handles.back()) = static_cast<std::uint32_t>(handles.size() - 1);
    }
    for (const auto& [a, b, c] : triangles)
        if (!mesh.add_face(handles[a], handles[b], handles[c]).is_valid())
            return false;
    mesh.request_face_normals();
    mesh.update_face_normals();
    Quadrics::Handle quadrics;
    NoFlips::Handle no_flips;
    decimater.add(quadrics);
    decimater.add(no_flips);
    // where the surface is flat three vertices on a line cost nothing, and have no normal
    NoNeedles::Handle no_needles;
    decimater.add(no_needles);
    decimater.module(no_needles).set_aspect_ratio(longest_needle);
    decimater.module(quadrics).unset_max_err(); // the number of triangles ends it, not the error
    return decimater.initialize();
}

Mesh Simplifier::State::current() const {
    std::vector<std::uint32_t> kept;
    for (const auto vertex : mesh.vertices())
        kept.push_back(mesh.property(index, vertex));
    std::ranges::sort(kept);
    Mesh result;
    for (const auto original : kept)
        result.positions.push_back(positions[original]);
    for (const auto face : mesh.faces()) {
        Triangle triangle{};
        std::size_t corner = 0;
        for (const auto vertex : face.vertices())
            triangle[corner++] = static_cast<std::uint32_t>(
                std::ranges::lower_bound(kept, mesh.property(index, vertex)) - kept.begin());
        result.triangles.push_back(triangle);
    }
    return result;
}

Simplifier::Simplifier(std::unique_ptr<State> state) : state_(std::move(state)) {}

Simplifier::Simplifier(Simplifier&&) noexcept = default;
Simplifier& Simplifier::operator=(Simplifier&&) noexcept = default;
Simplifier::~Simplifier() = default;

Expected<Simplifier> Simplifier::prepare(const Mesh& mesh) {
    auto state = std::make_unique<State>(mesh);
    if (!is_closed_manifold(state->before))
        return tl::make_unexpected(what_is_wrong(state->before));
    if (!(state->before.volume > 0))
        return tl::make_unexpected(
            fmt::format("a volume of {:.3g}, expected triangles that face outward around some",
                        state->before.volume));
    if (!state->build(mesh.triangles))
        return tl::make_unexpected("only a closed manifold can be simplified and stay one, but "
                                   "some triangle does not fit to its neighbours");
    return Simplifier(std::move(state));
}

Expected<Mesh> Simplifier::down_to(std::size_t triangles) {
    state_->decimater.decimate_to_faces(0, triangles);
    state_->mesh.garbage_collection(); // or collapsed triangles would count in the next step
    auto result = state_->current();
    if (result.triangles.size() > triangles)
        return tl::make_unexpected(fmt::format(
            "{} triangles are the fewest that keep its pieces and handles, expected no fewer than "
            "that instead of {}",
            result.triangles.size(), triangles));
    if (!has_kept_its_shape(state_->before, examine(result)))
        return tl::make_unexpected(fmt::format(
            "with {} triangles it would no longer be the closed surface that it was, expected more "
            "than that",
            triangles));
    return result;
}

Expected<Mesh> simplify(const Mesh& mesh, std::size_t triangles) {
    return Simplifier::prepare(mesh).and_then(
        [&](Simplifier simplifier) { return simplifier.down_to(triangles); });
}

} // namespace renderer::geometry
