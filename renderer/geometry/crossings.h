// Where a ray is inside the material: all its crossings of the surface, walked from the far end.
//
// The far end of a ray is outside; every crossing changes how many surfaces enclose the ray by one,
// and the state at the origin is derived, never guessed from a normal.  A count outside what one
// body gives is asked again a hair beside: where the surface overlaps or folds through itself (most
// scans do somewhere), the neighbour sees the same; where a ray grazed an edge, it does not.  When
// no two rays agree, every gap between crossings is classified by its winding number.  Near the
// openings of a surface that is not closed, winding numbers decide where the inside ends.
#pragma once

#include "renderer/geometry/openings.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/geometry/side.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace renderer::geometry {

/// What the tracing met, over all rays.
struct RayStatistics {
    std::uint64_t rays = 0;
    std::uint64_t retried = 0;       ///< asked again with the direction jittered
    std::uint64_t fallbacks = 0;     ///< classified by winding number in the end
    std::uint64_t past_openings = 0; ///< so near an opening that the winding number had to decide

    RayStatistics& operator+=(const RayStatistics& other);
};

/// Follows rays through one surface, one at a time; every thread makes its own.  The answers
/// depend on the ray alone, not on what was asked before.
///
/// Overlapping bodies of one material count once; a component that faces inward is a cavity; where
/// a fold turns the surface inside out, there is nothing.
class InteriorTracer {
  public:
    /// `scene` must outlive the tracer.
    explicit InteriorTracer(const RayScene& scene) : scene_(&scene) {}

    /// Of a surface with openings; `scene` shows it with its covers.  Both must outlive the tracer.
    InteriorTracer(const RayScene& scene, const OpenInterior& interior)
        : scene_(&scene), open_(&interior) {}

    /// Stretches inside the material on the ray from a vertex of the mesh, nearest first.  The
    /// triangles that meet in the vertex are not crossings.  Valid until the next question.
    /// Errors: EXPECTS a vertex there is and a unit direction (1e-6).
    std::span<const Segment> from_vertex(std::uint32_t vertex, glm::dvec3 direction);

    /// `from_vertex` for many vertices in one direction: the same to the last bit, and half as fast
    /// again where vertices that follow each other are neighbours.  `take(i, segments)` is called
    /// for every vertices[i] in turn.
    template <class Take>
    void
    from_vertices(std::span<const std::uint32_t> vertices, glm::dvec3 direction, const Take& take) {
        for (std::size_t first = 0; first < vertices.size(); first += RayScene::bundle_size) {
            const auto bundle =
                vertices.subspan(first, std::min(RayScene::bundle_size, vertices.size() - first));
            follow_bundle(bundle, direction);
            for (std::size_t i = 0; i < bundle.size(); ++i)
                take(first + i, from_bundle(i, bundle[i], direction));
        }
    }

    /// The same from any point, in model coordinates, inside or outside.  What the caller knows
    /// about the point is one more check: a ray that grazes an edge may meet one of its triangles
    /// and not the other, and the count is wrong without looking odd.  The surface has the last
    /// word, where rays beside each other agree that the caller is wrong.
    std::span<const Segment>
    from_point(glm::dvec3 point, glm::dvec3 direction, Side side = Side::Unknown);

    /// The triangle of the crossing at `distance`, model units, where a segment of the last answer
    /// begins or ends.
    std::uint32_t triangle_at(double distance) const;

    const RayStatistics& statistics() const { return statistics_; }

  private:
    struct Origin {
        glm::vec3 position; // scene coordinates
        std::optional<std::uint32_t> vertex;
        Side side = Side::Unknown;
    };

    void follow_bundle(std::span<const std::uint32_t> vertices, glm::dvec3 direction);
    std::span<const Segment> from_bundle(std::size_t i, std::uint32_t vertex, glm::dvec3 direction);
    std::span<const Segment> trace(const Origin& origin, glm::dvec3 direction);
    std::span<const Segment> trace_again(const Origin& origin, glm::dvec3 direction);
    std::span<const Segment> finished(const Origin& origin, glm::dvec3 direction);
    std::span<const Segment> in_model_units();
    bool resolve(const Origin& origin, glm::dvec3 direction);
    bool resolve_hits(Side side);
    void collect(const Origin& origin, glm::dvec3 direction);
    void order_hits(const Origin& origin);
    bool merge();
    bool walk(Side side);
    bool is_confirmed();
    void classify_gaps(const Origin& origin, glm::dvec3 direction);
    bool share_a_corner(std::uint32_t a, std::uint32_t b) const;

    double winding(glm::dvec3 point) const;

    const RayScene* scene_;
    const OpenInterior* open_ = nullptr; // of a surface with openings
    RayStatistics statistics_;
    std::vector<Hit> hits_;         // of the ray in hand, farthest first
    std::vector<Segment> segments_; // of the ray in hand
    RayScene::BundleHits bundle_;   // of the bundle in hand
    std::vector<bool> doubtful_;    // senses of the crossings of the neighbour that was in doubt
};

} // namespace renderer::geometry
