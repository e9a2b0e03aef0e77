// Two points whose cells are (i, j, k) apart are at least the length of (|i|-1, |j|-1, |k|-1)+
// cells apart: a sum over axes, so the least of it over all occupied cells is found axis by axis.
#include "renderer/reference/clearance.h"

#include "renderer/contract.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace renderer::reference {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Half an edge of the cube that the grid fills: scenes have unit diameter, and rounding.
constexpr float half_edge = 0.501f;

/// The least, over `line`, of its values plus the squared gap between their cells and each cell.
void spread_line(std::vector<float>& line, std::vector<float>& result) {
    const int n = static_cast<int>(line.size());
    std::fill(result.begin(), result.end(), infinity);
    for (int from = 0; from < n; ++from) {
        const float value = line[static_cast<std::size_t>(from)];
        if (value == infinity)
            continue;
        for (int to = 0; to < n; ++to) {
            const auto gap = static_cast<float>(std::max(std::abs(from - to) - 1, 0));
            auto& least = result[static_cast<std::size_t>(to)];
            least = std::min(least, value + gap * gap);
        }
    }
}

} // namespace

Clearance::Clearance(const geometry::RayScene& scene, int cells) : cells_(cells) {
    EXPECTS(cells >= 1 && cells <= 256);
    const auto n = static_cast<std::size_t>(cells);
    bounds_.assign(n * n * n, infinity);
    for (const auto& [a, b, c] : scene.triangles())
        occupy(scene.positions()[a], scene.positions()[b], scene.positions()[c]);
    spread();
    // A hair less than the bound: float arithmetic of those who compare with it.
    const float cell = 2 * half_edge / static_cast<float>(cells) * (1 - 1e-5f);
    for (auto& bound : bounds_)
        bound = cell * std::sqrt(bound);
}

float Clearance::at(glm::vec3 point) const {
    const glm::vec3 size = glm::abs(point);
    if (!(std::max({size.x, size.y, size.z}) < half_edge))
        return 0;
    return bounds_[index(cell_of(point.x), cell_of(point.y), cell_of(point.z))];
}

std::size_t Clearance::index(int x, int y, int z) const {
    return static_cast<std::size_t>((z * cells_ + y) * cells_ + x);
}

int Clearance::cell_of(float coordinate) const {
    const float cell = (coordinate + half_edge) / (2 * half_edge) * static_cast<float>(cells_);
    return std::clamp(static_cast<int>(cell), 0, cells_ - 1);
}

/// Marks every cell the triangle touches, and a few it does not: boxes around pieces of it.
void Clearance::occupy(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const float cell = 2 * half_edge / static_cast<float>(cells_);
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
                bounds_[index(x, y, z)] = 0;
}

void Clearance::spread() {
    std::vector<float> line(static_cast<std::size_t>(cells_)), result(line);
    const auto along = [&](auto&& cell) {
        for (int i = 0; i < cells_; ++i)
            line[static_cast<std::size_t>(i)] = bounds_[cell(i)];
        spread_line(line, result);
        for (int i = 0; i < cells_; ++i)
            bounds_[cell(i)] = result[static_cast<std::size_t>(i)];
    };
    for (int u = 0; u < cells_; ++u)
        for (int v = 0; v < cells_; ++v)
            along([&](int i) { return index(i, u, v); });
    for (int u = 0; u < cells_; ++u)
        for (int v = 0; v < cells_; ++v)
            along([&](int i) { return index(u, i, v); });
    for (int u = 0; u < cells_; ++u)
        for (int v = 0; v < cells_; ++v)
            along([&](int i) { return index(u, v, i); });
}

} // namespace renderer::reference
