// Two points whose cells are (i, j, k) apart are at least the length of (|i|-1, |j|-1, |k|-1)+
// cells apart: a sum over axes, so the least of it over all occupied cells is found axis by axis.
#include "renderer/reference/clearance.h"

#include "renderer/contract.h"
#include "renderer/geometry/crossings.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace renderer::reference {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Bounds are kept in quarters of a cell, rounded down.
constexpr float steps_in_cell = 4;

constexpr float most_steps = 126; // that a code has room for

} // namespace

Clearance::Clearance(const geometry::RayScene& scene, int cells)
    : cells_(cells), cells_per_unit_(static_cast<float>(cells) / (2 * half_edge)) {
    EXPECTS(cells >= 1 && cells <= 256);
    const auto n = static_cast<std::size_t>(cells);
    squares_.assign(n * n * n, infinity);
    for (const auto& [a, b, c] : scene.triangles())
        occupy(scene.positions()[a], scene.positions()[b], scene.positions()[c]);
    tell_sides(scene);
    spread();
    for (std::size_t i = 0; i < codes_.size(); ++i)
        if (codes_[i] != 0)
            codes_[i] += static_cast<std::uint8_t>(
                std::min(most_steps, steps_in_cell * std::sqrt(squares_[i])));
    squares_ = {};
    // A hair less than the bound: float arithmetic of those who compare with it.
    step_ = (1 - 1e-5f) / (steps_in_cell * cells_per_unit_);
}

glm::vec3 Clearance::centre(int x, int y, int z) const {
    return (glm::vec3(x, y, z) + 0.5f) / cells_per_unit_ - half_edge;
}

int Clearance::cell_of(float coordinate) const {
    return std::clamp(static_cast<int>(cells_per_unit_ * (coordinate + half_edge)), 0, cells_ - 1);
}

/// Marks every cell the triangle touches, and a few it does not: boxes around pieces of it.
void Clearance::occupy(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const float cell = 1 / cells_per_unit_;
    const float ab = glm::distance(a, b), bc = glm::distance(b, c), ca = glm::distance(c, a);
    const float longest = std::max({ab, bc, ca});
    if (longest > cell) {
        if (ab == longest)
            std::swap(a, c), std::swap(b, c); // now the longest edge is b to c
        else if (ca == longest)
            std::swap(a, b), std::swap(b, c), std::swap(b, c);
        const glm::vec3 middle = 0.5f * (b + c);
        occupy(a, b, middle);
        occupy(a, middle, c);
        return;
    }
    const float hair = 1e-4f * cell; // halving rounds
    const glm::vec3 low = glm::min(glm::min(a, b), c) - hair;
    const glm::vec3 high = glm::max(glm::max(a, b), c) + hair;
    for (int z = cell_of(low.z); z <= cell_of(high.z); ++z)
        for (int y = cell_of(low.y); y <= cell_of(high.y); ++y)
            for (int x = cell_of(low.x); x <= cell_of(high.x); ++x)
                squares_[index(x, y, z)] = 0;
}

/// One ray through the middle of each column: where the middle of a cell is that the surface does
/// not touch, all of it is.
void Clearance::tell_sides(const geometry::RayScene& scene) {
    codes_.assign(squares_.size(), 0);
    const geometry::DenormalsAreZero guard;
    geometry::InteriorTracer tracer(scene);
    const double size = scene.model_per_scene();
    for (int y = 0; y < cells_; ++y)
        for (int x = 0; x < cells_; ++x) {
            const glm::dvec3 below(centre(x, y, -1));
            const auto stretches = tracer.from_point(scene.model_from_scene(below), {0, 0, 1},
                                                     geometry::Side::Outside);
            for (int z = 0; z < cells_; ++z) {
                const double along = size * (static_cast<double>(centre(x, y, z).z) - below.z);
                const bool is_inside = std::ranges::any_of(
                    stretches, [&](const auto& s) { return s.begin < along && along < s.end; });
                if (squares_[index(x, y, z)] > 0)
                    codes_[index(x, y, z)] = is_inside ? untouched : outside | untouched;
            }
        }
}

/// The least, over a line of cells, of their values plus the squared gap between them and each.
void Clearance::spread() {
    const auto n = static_cast<std::size_t>(cells_);
    std::vector<float> gaps(2 * n - 1); // gaps[n - 1 + i]: between cells i apart
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        const int apart = std::abs(static_cast<int>(i) - (cells_ - 1));
        const auto gap = static_cast<float>(std::max(apart - 1, 0));
        gaps[i] = gap * gap;
    }
    std::vector<float> line(n), result(n);
    const auto along = [&](std::size_t first, std::size_t stride) {
        for (std::size_t i = 0; i < n; ++i)
            line[i] = squares_[first + i * stride];
        std::fill(result.begin(), result.end(), infinity);
        for (std::size_t from = 0; from < n; ++from)
            if (line[from] < infinity)
                for (std::size_t to = 0; to < n; ++to)
                    result[to] = std::min(result[to], line[from] + gaps[n - 1 - from + to]);
        for (std::size_t i = 0; i < n; ++i)
            squares_[first + i * stride] = result[i];
    };
    for (std::size_t u = 0; u < n; ++u)
        for (std::size_t v = 0; v < n; ++v)
            along((u * n + v) * n, 1);
    for (std::size_t u = 0; u < n; ++u)
        for (std::size_t v = 0; v < n; ++v)
            along(u * n * n + v, n);
    for (std::size_t u = 0; u < n; ++u)
        for (std::size_t v = 0; v < n; ++v)
            along(u * n + v, n * n);
}

} // namespace renderer::reference
