// How much material surely lies on the way to a sun: what spares collisions deep in its shadow the
// asking.
#pragma once

#include "renderer/geometry/crossings.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/reference/clearance.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace renderer::reference {

/// Lower bounds on the length inside from any point toward one direction, in model units: a grid
/// along that direction, whose columns a ray does not leave.
class SunwardDepth {
  public:
    /// `cells` along an edge of the cube, 1..255; memory is a byte for each cell.  `scene` must
    /// outlive this.
    SunwardDepth(const geometry::RayScene& scene,
                 const Clearance& clearance,
                 glm::dvec3 to_light,
                 int cells = 96);

    /// 0 outside the grid.
    double at(glm::dvec3 point) const;

  private:
    std::size_t column(int u, int v) const;
    void fill(int u,
              int v,
              const Clearance& clearance,
              geometry::InteriorTracer& tracer,
              glm::dvec3 to_light);

    const geometry::RayScene& scene_;
    glm::mat3 grid_from_scene_; ///< rotation: the light's direction becomes the third axis
    int cells_;
    double step_;                     ///< model units
    std::vector<std::uint8_t> ahead_; ///< cells inside with all they hold, beyond each cell
};

} // namespace renderer::reference
