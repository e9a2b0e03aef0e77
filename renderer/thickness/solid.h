// A mesh made ready for asking where rays are inside it.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/crossings.h"
#include "renderer/geometry/mesh.h"
#include "renderer/geometry/openings.h"
#include "renderer/geometry/ray_scene.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

namespace renderer::thickness {

/// The mesh as rays meet it; where it has openings, with what decides there.  May be asked from
/// several threads at once.
class Solid {
  public:
    /// Copies what it needs.  Errors: what is no solid, see traceable.h.
    static Expected<std::shared_ptr<const Solid>> of(const geometry::Mesh& mesh);

    explicit Solid(const geometry::CoveredMesh& covered);
    Solid(const Solid&) = delete; // `interior_` looks at this one's scene
    Solid& operator=(const Solid&) = delete;

    /// With the covers of openings, if there are any.
    const geometry::RayScene& scene() const { return scene_; }

    /// For one thread; this must outlive it.
    geometry::InteriorTracer tracer() const;

    /// The mesh's own, in scene coordinates.
    std::span<const glm::vec3> vertices() const { return scene_.positions().first(vertices_); }

  private:
    geometry::RayScene scene_;
    std::size_t vertices_;
    std::optional<geometry::OpenInterior> interior_;
};

} // namespace renderer::thickness
