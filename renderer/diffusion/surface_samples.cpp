// Vertices where they are dense enough, points drawn from a fine tiling of the triangles where not.
#include "renderer/diffusion/surface_samples.h"

#include "renderer/contract.h"
#include "renderer/splitmix.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace renderer::diffusion {

namespace {

using geometry::Mesh;

// At 0.65 of the wanted spacing, what a kernel of that width sums up to is 0.3 % off in the mean
// and 1 % in the worst place (0.6 % and 2.4 % at 0.8).  A maximal random packing of disks leaves
// each point 1.44 of its squared radius.
constexpr double radius_per_spacing = 0.65;
constexpr double area_per_squared_radius = 1.44;

// Candidates are cells no longer than this part of the radius: about fifteen to a sample, so that
// areas and centroids are right to a few per cent.  Half as long, they take a seventh off the
// error.
constexpr double cell_per_radius = 0.5;

// Cosine between triangles above which they belong to one sheet: below it lie the sides of an edge
// and the back of a thin wall.
constexpr float same_side = 0.1F;

struct Corner {
    glm::dvec3 position, normal;
};

/// A cell of the tiling: a piece of a triangle, taken at its centroid.
struct Candidate {
    glm::dvec3 position;
    glm::vec3 normal; ///< of the smooth surface
    glm::vec3 facing; ///< of the triangle
    float area;
};

double area_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

glm::dvec3 unit_or_zero(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

/// Halves the longest edge until none is longer than `longest`, and keeps what is left.
void tile(const std::array<Corner, 3>& corners,
          glm::dvec3 facing,
          double longest,
          std::vector<Candidate>& cells) {
    std::size_t worst = 0;
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (const double l = glm::distance(corners[k].position, corners[(k + 1) % 3].position);
            l > length) {
            length = l;
            worst = k;
        }
    const auto& [a, b, c] = corners;
    if (length <= longest) {
        cells.push_back({(a.position + b.position + c.position) / 3.0,
                         unit_or_zero(a.normal + b.normal + c.normal), facing,
                         static_cast<float>(area_of(a.position, b.position, c.position))});
        return;
    }
    const auto &from = corners[worst], &to = corners[(worst + 1) % 3],
               &apex = corners[(worst + 2) % 3];
    const Corner middle{0.5 * (from.position + to.position), 0.5 * (from.normal + to.normal)};
    tile({from, middle, apex}, facing, longest, cells);
    tile({middle, to, apex}, facing, longest, cells);
}

std::vector<Candidate> tile_surface(const Mesh& mesh, double longest) {
    const auto normals = geometry::vertex_normals(mesh);
    std::vector<Candidate> cells;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
        const auto facing = unit_or_zero(glm::cross(q - p, r - p));
        if (facing != glm::dvec3(0))
            tile({Corner{p, normals[a]}, Corner{q, normals[b]}, Corner{r, normals[c]}}, facing,
                 longest, cells);
    }
    return cells;
}

/// Candidates by cubes of one radius: all neighbours within a radius are in the 27 around.
class Neighbourhood {
  public:
    Neighbourhood(const std::vector<Candidate>& candidates, double radius)
        : candidates_(candidates), radius_(radius), order_(candidates.size()) {
        std::vector<std::uint64_t> keys;
        keys.reserve(candidates.size());
        for (const auto& candidate : candidates)
            keys.push_back(key(cube(candidate.position)));
        std::iota(order_.begin(), order_.end(), 0u);
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
        });
        for (std::uint32_t begin = 0; begin < order_.size();) {
            std::uint32_t end = begin + 1;
            while (end < order_.size() && keys[order_[end]] == keys[order_[begin]])
                ++end;
            ranges_.emplace(keys[order_[begin]], std::pair(begin, end));
            begin = end;
        }
    }

    /// Calls `visit(index, squared distance)` for every candidate within a radius of `centre` that
    /// faces the same way: the other side of a thin sheet is another surface.
    template <class Visit>
    void for_each_near(const Candidate& centre, Visit visit) const {
        const auto [x, y, z] = cube(centre.position);
        for (std::int64_t i = x - 1; i <= x + 1; ++i)
            for (std::int64_t j = y - 1; j <= y + 1; ++j)
                for (std::int64_t k = z - 1; k <= z + 1; ++k)
                    if (const auto found = ranges_.find(key({i, j, k})); found != ranges_.end())
                        visit_range(found->second, centre, visit);
    }

  private:
    using Cube = std::array<std::int64_t, 3>;
    using Range = std::pair<std::uint32_t, std::uint32_t>;

    Cube cube(glm::dvec3 p) const {
        return {static_cast<std::int64_t>(std::floor(p.x / radius_)),
                static_cast<std::int64_t>(std::floor(p.y / radius_)),
                static_cast<std::int64_t>(std::floor(p.z / radius_))};
    }

    /// 21 bits of each coordinate: distinct cubes share a key only when millions of radii apart.
    static std::uint64_t key(const Cube& cube) {
        constexpr std::uint64_t mask = (1u << 21) - 1;
        return (static_cast<std::uint64_t>(cube[0]) & mask) |
               (static_cast<std::uint64_t>(cube[1]) & mask) << 21 |
               (static_cast<std::uint64_t>(cube[2]) & mask) << 42;
    }

    template <class Visit>
    void visit_range(Range range, const Candidate& centre, Visit& visit) const {
        for (auto at = range.first; at < range.second; ++at) {
            const auto& other = candidates_[order_[at]];
            const auto away = other.position - centre.position;
            const double squared = glm::dot(away, away);
            if (squared <= radius_ * radius_ && glm::dot(other.facing, centre.facing) > same_side)
                visit(order_[at], squared);
        }
    }

    const std::vector<Candidate>& candidates_;
    double radius_;
    std::vector<std::uint32_t> order_;
    std::unordered_map<std::uint64_t, Range> ranges_;
};

std::vector<std::uint32_t> shuffled(std::size_t count, std::uint64_t seed) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t left = count; left > 1; --left)
        std::swap(order[left - 1],
                  order[static_cast<std::size_t>(uniform(seed) * static_cast<double>(left))]);
    return order;
}

double longest_edge(const Mesh& mesh) {
    double longest = 0;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            longest = std::max(longest,
                               glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]));
    return longest;
}

double surface_area(const Mesh& mesh) {
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area += area_of(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    return area;
}

} // namespace

Medium in_model_units(const Medium& medium, double mm_per_unit) {
    EXPECTS(mm_per_unit > 0);
    const auto scaled = [&](RgbPerMillimetre sigma) {
        return RgbPerMillimetre{sigma.r * mm_per_unit, sigma.g * mm_per_unit,
                                sigma.b * mm_per_unit};
    };
    return {scaled(medium.sigma_a), scaled(medium.sigma_s_reduced), medium.index};
}

double wanted_spacing(const Medium& medium) {
    const auto &a = medium.sigma_a, &s = medium.sigma_s_reduced;
    return 1 / std::max({a.r + s.r, a.g + s.g, a.b + s.b});
}

SurfaceSamples vertex_samples(const Mesh& mesh) {
    SurfaceSamples samples;
    samples.positions = mesh.positions;
    samples.normals = geometry::vertex_normals(mesh);
    samples.areas.resize(mesh.positions.size());
    std::vector<glm::dvec3> moments(mesh.positions.size());
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto &a = mesh.positions[t[k]], &b = mesh.positions[t[(k + 1) % 3]],
                       &c = mesh.positions[t[(k + 2) % 3]];
            const double third = area_of(a, b, c) / 3;
            samples.areas[t[k]] += third;
            // the third of a triangle nearest to a corner has its centroid here
            moments[t[k]] += third * (22.0 * a + 7.0 * b + 7.0 * c) / 36.0;
        }
    for (std::size_t v = 0; v < moments.size(); ++v)
        samples.centroids.push_back(samples.areas[v] > 0 ? moments[v] / samples.areas[v]
                                                         : mesh.positions[v]);
    samples.spacing = std::sqrt(surface_area(mesh) / static_cast<double>(mesh.positions.size()));
    return samples;
}

SurfaceSamples poisson_samples(const Mesh& mesh, const SamplingOptions& options) {
    EXPECTS(options.spacing > 0);
    const double radius = radius_per_spacing * options.spacing;
    const auto candidates = tile_surface(mesh, cell_per_radius * radius);
    const Neighbourhood neighbourhood(candidates, radius);
    constexpr auto nobody = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> owner(candidates.size(), nobody);
    std::vector<double> squared(candidates.size(), std::numeric_limits<double>::infinity());

    SurfaceSamples samples;
    for (const auto chosen : shuffled(candidates.size(), options.seed)) {
        if (owner[chosen] != nobody)
            continue;
        const auto sample = static_cast<std::uint32_t>(samples.positions.size());
        samples.positions.push_back(candidates[chosen].position);
        samples.normals.push_back(unit_or_zero(candidates[chosen].normal));
        neighbourhood.for_each_near(candidates[chosen], [&](std::uint32_t near, double distance) {
            if (distance < squared[near]) {
                squared[near] = distance;
                owner[near] = sample;
            }
        });
    }
    samples.areas.resize(samples.positions.size());
    std::vector<glm::dvec3> moments(samples.positions.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        samples.areas[owner[i]] += static_cast<double>(candidates[i].area);
        moments[owner[i]] += static_cast<double>(candidates[i].area) * candidates[i].position;
    }
    for (std::size_t q = 0; q < moments.size(); ++q)
        samples.centroids.push_back(moments[q] / samples.areas[q]);
    samples.spacing = options.spacing;
    return samples;
}

SurfaceSamples sample_surface(const Mesh& mesh, const SamplingOptions& options) {
    EXPECTS(options.spacing > 0 && options.most_samples >= 1);
    const double area = surface_area(mesh);
    EXPECTS(area > 0);
    if (longest_edge(mesh) <= options.spacing)
        return vertex_samples(mesh);
    const double per_sample = area_per_squared_radius * radius_per_spacing * radius_per_spacing;
    const double finest = std::sqrt(area / per_sample / static_cast<double>(options.most_samples));
    auto within = options;
    within.spacing = std::max(options.spacing, finest);
    auto samples = poisson_samples(mesh, within);
    samples.undersampled = options.spacing < finest;
    return samples;
}

} // namespace renderer::diffusion
