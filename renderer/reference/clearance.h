// How far from the surface one surely is: what spares a walk most of its rays.
#pragma once

#include "renderer/geometry/ray_scene.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace renderer::reference {

/// A grid of lower bounds on the distance to the nearest triangle, in scene coordinates.
class Clearance {
  public:
    /// `cells` along an edge of the scene's bounding cube, 1..256; memory is a byte for each cell.
    explicit Clearance(const geometry::RayScene& scene, int cells = 96);

    /// Scene units; 0 near the surface, and outside the grid.
    float at(glm::vec3 point) const;

    /// Whether `point` is inside, in a cell that the surface does not touch; false says nothing.
    bool is_surely_inside(glm::vec3 point) const;

  private:
    std::size_t index(int x, int y, int z) const;
    std::optional<std::size_t> cell_at(glm::vec3 point) const;
    glm::vec3 centre(int x, int y, int z) const;
    int cell_of(float coordinate) const;
    void occupy(glm::vec3 a, glm::vec3 b, glm::vec3 c);
    void spread();
    void note_insides(const geometry::RayScene& scene);

    int cells_;
    float cells_per_unit_;
    float step_ = 0;                  // scene units
    std::vector<float> squares_;      // while it is built: squared bounds, in cells
    std::vector<std::uint8_t> steps_; // bounds
    std::vector<bool> insides_;       // cells that are inside altogether
};

} // namespace renderer::reference
