// A surface with openings: what closes it, and where its inside ends.
//
// A point is inside when the surface winds around it by more than a half [Jacobson2013, sec. 4].
// Nothing has to be summed over the surface for that: with the openings covered by any triangles at
// all, rays count whole numbers, and the open surface's winding number is that count less what the
// covers alone wind.  So it is exact, costs nothing far from an opening, and does not depend on how
// the openings were covered.
#pragma once

#include "renderer/geometry/mesh.h"
#include "renderer/geometry/ray_scene.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace renderer::geometry {

/// A mesh and the covers of its openings.  The mesh's own vertices and triangles come first.
struct CoveredMesh {
    Mesh mesh;
    std::size_t own_vertices = 0;
    std::size_t own_triangles = 0;
};

/// Covers every opening with triangles that meet in the middle of its rim.  Closed meshes come back
/// as they are.  Edges that are passed twice the same way are rims too; whether that makes sense is
/// for the caller to decide (`examine`).
CoveredMesh cover_openings(const Mesh& mesh);

/// A stretch of a ray inside the material, begin < end.
struct Segment {
    double begin = 0; ///< exactly 0 when the ray starts inside
    double end = 0;
};

/// Where rays are inside an open surface.  May be asked from several threads at once.
class OpenInterior {
  public:
    /// `scene` shows the covered mesh and must outlive this.
    OpenInterior(const RayScene& scene, std::size_t own_triangles);

    /// False when the covers wind around every point of the ray by less than a half: then the
    /// openings change nothing, and counting the crossings of surface and covers is enough.
    /// Units: scene coordinates.
    bool may_matter(glm::vec3 origin, glm::dvec3 direction) const;

    /// The stretches inside, farthest first, of a ray whose crossings of surface and covers are
    /// `hits`, farthest first.  Where no surface ends a stretch, the winding number of one half
    /// does, found to 1e-7.  Replaces what `segments` held.  Units: scene coordinates.
    void follow(glm::vec3 origin,
                glm::dvec3 direction,
                std::span<const Hit> hits,
                std::vector<Segment>& segments) const;

    /// How often the open surface alone winds around a point in scene coordinates.
    double winding(glm::dvec3 point) const;

  private:
    class Ray;

    struct Cover {
        glm::dvec3 centre{};
        double radius = 0; ///< of the sphere around it
        double area = 0;
    };

    double covers_winding(glm::dvec3 point) const;

    const RayScene* scene_;
    std::size_t own_triangles_;
    std::vector<Cover> covers_;
};

} // namespace renderer::geometry
