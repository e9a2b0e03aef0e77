// Surely: a cell counts when the ray through its centre is inside there and the surface is farther
// than the cell's corners.  Likely: between the rays through the centres of four columns.
#include "renderer/reference/sunward_depth.h"

#include "renderer/contract.h"
#include "renderer/geometry/crossings.h"
#include "renderer/reference/phase.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace renderer::reference {

namespace {

// Half an edge of the cube: scenes have unit diameter, and rounding.
constexpr float half_edge = 0.501f;

// Half a cell's diagonal in cells, and a hair for the rounding of those who ask.
constexpr float half_diagonal = 0.867f;

constexpr double steps_in_cell = 256;

} // namespace

SunwardDepth::SunwardDepth(const geometry::RayScene& scene,
                           const Clearance& clearance,
                           glm::dvec3 to_light,
                           int cells)
    : scene_(scene), cells_(cells),
      cell_(scene.model_per_scene() * 2 * static_cast<double>(half_edge) / cells) {
    EXPECTS(cells >= 2 && cells <= 255);
    const glm::dvec3 u = around(to_light, 0, 0), v = glm::cross(to_light, u);
    grid_from_scene_ = glm::mat3(glm::transpose(glm::dmat3(u, v, to_light)));
    const auto n = static_cast<std::size_t>(cells);
    ahead_.assign(n * n * n, 0);
    depths_.assign(n * n * n, 0);
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
    const glm::dvec3 start(scene_from_grid * glm::vec3(centre(u), centre(v), -1));
    const auto stretches =
        tracer.from_point(scene_.model_from_scene(start), to_light, geometry::Side::Outside);
    const auto length_beyond = [&](double along) {
        double length = 0;
        for (const auto& s : stretches)
            length += std::max(0.0, s.end - std::max(s.begin, along));
        return length;
    };
    std::uint8_t ahead = 0;
    for (int w = cells_ - 1; w >= 0; --w) {
        ahead_[column(u, v) + static_cast<std::size_t>(w)] = ahead;
        const glm::vec3 middle = scene_from_grid * glm::vec3(centre(u), centre(v), centre(w));
        const double along = scene_.model_per_scene() * (static_cast<double>(centre(w)) + 1);
        depths_[column(u, v) + static_cast<std::size_t>(w)] =
            static_cast<std::uint16_t>(steps_in_cell * length_beyond(along) / cell_ + 0.5);
        const bool is_inside = std::ranges::any_of(stretches, [&](const geometry::Segment& s) {
            return s.begin < along && along < s.end;
        });
        if (is_inside && clearance.at(middle) > half_diagonal * cell)
            ++ahead;
    }
}

DepthGuess SunwardDepth::at(glm::dvec3 point) const {
    const auto n = static_cast<float>(cells_);
    const glm::vec3 place =
        (grid_from_scene_ * glm::vec3(scene_.scene_from_model(point)) + half_edge) *
        (n / (2 * half_edge));
    DepthGuess guess{0, 0, std::numeric_limits<double>::max()};
    const bool is_in_grid = place.x >= 0.5f && place.x < n - 0.5f && place.y >= 0.5f &&
                            place.y < n - 0.5f && place.z >= 0.5f && place.z < n - 0.5f;
    if (!is_in_grid)
        return guess;
    const std::size_t first = column(static_cast<int>(place.x), static_cast<int>(place.y));
    guess.least = (1 - 1e-5) * cell_ * ahead_[first + static_cast<std::size_t>(place.z)];
    interpolate(guess, place - 0.5f);
    return guess;
}

/// Between the centres of eight cells.  Depths that fall by a cell or stay from one to the next are
/// exact in between; others have the surface there.
void SunwardDepth::interpolate(DepthGuess& guess, glm::vec3 place) const {
    const int u = static_cast<int>(place.x), v = static_cast<int>(place.y);
    const auto w = static_cast<std::size_t>(place.z);
    const float x = place.x - static_cast<float>(u), y = place.y - static_cast<float>(v);
    const float z = place.z - static_cast<float>(w);
    const std::array<std::size_t, 4> columns{column(u, v), column(u + 1, v), column(u, v + 1),
                                             column(u + 1, v + 1)};
    const std::array<float, 4> shares{(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
    constexpr auto whole = static_cast<float>(steps_in_cell);
    float likely = 0, low = std::numeric_limits<float>::max(), high = 0, surface = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const float here = depths_[columns[i] + w], beyond = depths_[columns[i] + w + 1];
        const float depth = here + z * (beyond - here);
        likely += shares[i] * depth;
        low = std::min(low, depth);
        high = std::max(high, depth);
        surface = std::max(surface, std::min(here - beyond, whole - (here - beyond)));
    }
    const double unit = cell_ / steps_in_cell;
    guess.likely = unit * static_cast<double>(likely);
    guess.spread = unit * static_cast<double>(high - low + surface);
}

std::size_t SunwardDepth::column(int u, int v) const {
    return static_cast<std::size_t>(v * cells_ + u) * static_cast<std::size_t>(cells_);
}

} // namespace renderer::reference
