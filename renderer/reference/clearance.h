// How far from the surface one surely is: what spares a walk most of its rays.
#pragma once

#include "renderer/geometry/ray_scene.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace renderer::reference {

/// A grid of lower bounds on the distance to the nearest triangle, and of what is surely inside or
/// outside, in scene coordinates.
class Clearance {
  public:
    /// `cells` along an edge of the scene's bounding cube, 1..256; memory is a byte for each cell.
    explicit Clearance(const geometry::RayScene& scene, int cells = 96);

    /// Scene units, on either side; 0 near the surface and outside the grid.
    float at(glm::vec3 point) const {
        const unsigned bound = code_at(point) & bound_bits;
        return bound > untouched ? step_ * static_cast<float>(bound - untouched) : 0;
    }

    /// Whether `point` is inside, in a cell that the surface does not touch; false says nothing.
    bool is_surely_inside(glm::vec3 point) const {
        const std::uint8_t code = code_at(point);
        return code >= untouched && code < outside;
    }

    /// Whether `point` is outside, in a cell that the surface does not touch; false says nothing.
    bool is_surely_outside(glm::vec3 point) const { return code_at(point) >= outside; }

  private:
    // What a cell is: 0 where the surface may be, else one more than the bound in steps, and the
    // highest bit when it is outside.
    static constexpr std::uint8_t untouched = 1, bound_bits = 127, outside = 128;

    // Half an edge of the cube that the grid fills: scenes have unit diameter, and rounding.
    static constexpr float half_edge = 0.501f;

    std::uint8_t code_at(glm::vec3 point) const {
        const glm::vec3 place = cells_per_unit_ * (point + half_edge);
        const auto n = static_cast<float>(cells_);
        const bool is_in_grid = place.x >= 0 && place.x < n && place.y >= 0 && place.y < n &&
                                place.z >= 0 && place.z < n;
        return is_in_grid ? codes_[index(static_cast<int>(place.x), static_cast<int>(place.y),
                                         static_cast<int>(place.z))]
                          : outside; // and no bound
    }

    std::size_t index(int x, int y, int z) const {
        return static_cast<std::size_t>((z * cells_ + y) * cells_ + x);
    }

    glm::vec3 centre(int x, int y, int z) const;
    int cell_of(float coordinate) const;
    void occupy(glm::vec3 a, glm::vec3 b, glm::vec3 c);
    void spread();
    void tell_sides(const geometry::RayScene& scene);

    int cells_;
    float cells_per_unit_;
    float step_ = 0;             // scene units
    std::vector<float> squares_; // while it is built: squared bounds, in cells
    std::vector<std::uint8_t> codes_;
};

} // namespace renderer::reference
