// A cell counts when the ray through its centre is inside there and the surface is farther than the
// cell's corners.
#include "renderer/reference/sunward_depth.h"

#include "renderer/contract.h"
#include "renderer/geometry/crossings.h"
#include "renderer/reference/phase.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace renderer::reference {

namespace {

// Half an edge of the cube: scenes have unit diameter, and rounding.
constexpr float half_edge = 0.501f;

// Half a cell's diagonal in cells, and a hair for the rounding of those who ask.
constexpr float half_diagonal = 0.867f;

} // namespace

SunwardDepth::SunwardDepth(const geometry::RayScene& scene,
                           const Clearance& clearance,
                           glm::dvec3 to_light,
                           int cells)
    : scene_(scene), cells_(cells),
      step_((1 - 1e-5) * scene.model_per_scene() * 2 * static_cast<double>(half_edge) / cells) {
    EXPECTS(cells >= 1 && cells <= 255);
    const glm::dvec3 u = around(to_light, 0, 0), v = glm::cross(to_light, u);
    grid_from_scene_ = glm::mat3(glm::transpose(glm::dmat3(u, v, to_light)));
    const auto n = static_cast<std::size_t>(cells);
    ahead_.assign(n * n * n, 0);
    const geometry::DenormalsAreZero guard;
    geometry::InteriorTracer tracer(scene);
    for (int row = 0; row < cells; ++row)
        for (int i = 0; i < cells; ++i)
            fill(i, row, clearance, tracer, to_light);
}

/// One column, from its sunny end.
void SunwardDepth::fill(int u,
                        int v,
                        const Clearance& clearance,
                        geometry::InteriorTracer& tracer,
                        glm::dvec3 to_light) {
    const float cell = 2 * half_edge / static_cast<float>(cells_);
    const auto centre = [&](int i) { return cell * (static_cast<float>(i) + 0.5f) - half_edge; };
    const glm::mat3 scene_from_grid = glm::transpose(grid_from_scene_);
    const glm::dvec3 origin = scene_.scene_from_model({0, 0, 0});
    const glm::dvec3 start(scene_from_grid * glm::vec3(centre(u), centre(v), -1));
    const auto stretches = tracer.from_point(scene_.model_per_scene() * (start - origin), to_light,
                                             geometry::Side::Outside);
    std::uint8_t ahead = 0;
    for (int w = cells_ - 1; w >= 0; --w) {
        ahead_[column(u, v) + static_cast<std::size_t>(w)] = ahead;
        const glm::vec3 middle = scene_from_grid * glm::vec3(centre(u), centre(v), centre(w));
        const double along = scene_.model_per_scene() * (static_cast<double>(centre(w)) + 1);
        const bool is_inside = std::ranges::any_of(stretches, [&](const geometry::Segment& s) {
            return s.begin < along && along < s.end;
        });
        if (is_inside && clearance.at(middle) > half_diagonal * cell)
            ++ahead;
    }
}

double SunwardDepth::at(glm::dvec3 point) const {
    const auto n = static_cast<float>(cells_);
    const glm::vec3 place =
        (grid_from_scene_ * glm::vec3(scene_.scene_from_model(point)) + half_edge) *
        (n / (2 * half_edge));
    const bool is_in_grid =
        place.x >= 0 && place.x < n && place.y >= 0 && place.y < n && place.z >= 0 && place.z < n;
    if (!is_in_grid)
        return 0;
    const std::size_t first = column(static_cast<int>(place.x), static_cast<int>(place.y));
    return step_ * ahead_[first + static_cast<std::size_t>(place.z)];
}

std::size_t SunwardDepth::column(int u, int v) const {
    return static_cast<std::size_t>(v * cells_ + u) * static_cast<std::size_t>(cells_);
}

} // namespace renderer::reference
