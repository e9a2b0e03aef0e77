// How much material lies on the way to a sun: what spares most collisions the asking.
#pragma once

#include "renderer/geometry/crossings.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/reference/clearance.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace renderer::reference {

/// What is known of the length inside, from a point toward the sun, without a ray.  Model units.
struct DepthGuess {
    double least = 0;  ///< surely no less
    double likely = 0; ///< between the rays nearby
    double spread = 0; ///< how far those rays are apart, and the surface in between
};

/// Guesses for any point and one direction: a grid along that direction, whose columns a ray does
/// not leave.
class SunwardDepth {
  public:
    /// `cells` along an edge of the cube, 2..255; memory is three bytes for each cell.  `scene`
    /// must outlive this.
    SunwardDepth(const geometry::RayScene& scene,
                 const Clearance& clearance,
                 glm::dvec3 to_light,
                 int cells = 64);

    /// Near the grid's rim and outside nothing is known: 0, 0 and the greatest number.
    DepthGuess at(glm::dvec3 point) const;

  private:
    std::size_t column(int u, int v) const;
    void fill(int u,
              int v,
              const Clearance& clearance,
              geometry::InteriorTracer& tracer,
              glm::dvec3 to_light);
    void interpolate(DepthGuess& guess, glm::vec3 place) const;

    const geometry::RayScene& scene_;
    glm::mat3 grid_from_scene_; ///< rotation: the light's direction becomes the third axis
    int cells_;
    double cell_;                       ///< model units
    std::vector<std::uint8_t> ahead_;   ///< cells inside with all they hold, beyond each cell
    std::vector<std::uint16_t> depths_; ///< length inside beyond the centre, 1/256 of a cell
};

} // namespace renderer::reference
