// Tallies over many paths, in parallel and in order.
#include "renderer/reference/energy.h"

#include "renderer/contract.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/reference/phase.h"

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

namespace renderer::reference {

namespace {

constexpr std::uint64_t batches_in_group = 256;

/// Many paths are stratified in large batches, as long as a thousand are left for the error.
int log2_batch_of(std::uint64_t paths) {
    const int of_a_thousand = static_cast<int>(std::bit_width(paths >> 10)) - 1;
    return std::clamp(of_a_thousand, 6, 12);
}

std::uint64_t batches_of(std::uint64_t paths) {
    const std::uint64_t batch = std::uint64_t{1} << log2_batch_of(paths);
    return (paths + batch - 1) / batch;
}

enum Share : std::size_t { Back, Through, Escape, Absorbed, Roulette, Collisions, shares };

using Tally = std::array<double, shares>;

/// Sums one path after the other.
class EnergyTally final : public WalkEvents<1> {
  public:
    explicit EnergyTally(glm::dvec3 incident) : incident_(incident) {}

    void collided(const Path<1>& path, const Spectrum<1>& absorbed, PathRandom&) override {
        tally_[Absorbed] += absorbed[0];
        tally_[Collisions] += absorbed[0] + path.weight[0];
    }

    void met_surface(const Path<1>&, const RoughSurface&, PathRandom&) override {}

    void escaped(const Path<1>& path) override {
        const bool is_through = glm::dot(path.direction, incident_) > 0;
        tally_[is_through ? Through : Back] += path.weight[0];
        tally_[Escape] += path.weight[0];
    }

    void gambled(const Spectrum<1>& change) override { tally_[Roulette] -= change[0]; }

    void leaked() override { ++leaks_; }

    Tally taken() {
        const Tally all = tally_;
        tally_ = {};
        return all;
    }

    std::uint64_t leaks() const { return leaks_; }

  private:
    glm::dvec3 incident_;
    Tally tally_{};
    std::uint64_t leaks_ = 0;
};

/// Sums of batch means and of their squares.
struct Sums {
    Tally first{}, second{};
    std::uint64_t leaks = 0;
};

/// A path as it arrives; nothing when the ray misses.
using Start = std::function<std::optional<Path<1>>(PathRandom&, BodyTracer&)>;

struct Setting {
    const Body& body;
    Medium medium;
    Boundary boundary;
    glm::dvec3 incident{0, 0, -1};
    Start start;
};

Tally batch_mean(Walk<1>& walk,
                 EnergyTally& tally,
                 BodyTracer& tracer,
                 const Setting& setting,
                 std::uint64_t seed,
                 std::uint64_t number,
                 int log2_batch) {
    const auto high = static_cast<std::uint32_t>(number >> 32),
               low = static_cast<std::uint32_t>(number);
    const Strata strata(seed, high, low);
    double met = 0;
    for (std::uint32_t sample = 0; sample < (1u << log2_batch); ++sample) {
        PathRandom random({seed, high, low, sample, log2_batch}, strata);
        if (const auto path = setting.start(random, tracer)) {
            walk.start(*path);
            walk.follow(random);
            ++met;
        }
    }
    Tally mean = tally.taken();
    for (auto& share : mean)
        share /= std::max(met, 1.0);
    return mean;
}

Sums group_sums(const Setting& setting, const EnergyRun& run, std::uint64_t group) {
    const geometry::DenormalsAreZero guard;
    const auto tracer = setting.body.tracer();
    EnergyTally tally(setting.incident);
    Walk<1> walk(setting.medium, setting.boundary, setting.body, *tracer, tally, run.tactics);
    const int log2_batch = log2_batch_of(run.paths);
    const std::uint64_t all = batches_of(run.paths);
    const std::uint64_t first = group * batches_in_group;
    Sums sums;
    for (std::uint64_t b = first; b < std::min(first + batches_in_group, all); ++b) {
        const Tally mean = batch_mean(walk, tally, *tracer, setting, run.seed, b, log2_batch);
        for (std::size_t i = 0; i < shares; ++i) {
            sums.first[i] += mean[i];
            sums.second[i] += mean[i] * mean[i];
        }
    }
    sums.leaks = tally.leaks();
    return sums;
}

EnergyBalance balance_of(const Sums& sums, std::uint64_t batches, std::uint64_t paths) {
    const auto n = static_cast<double>(batches);
    const auto estimate = [&](Share share) {
        const double mean = sums.first[share] / n;
        const double variance = std::max(0.0, sums.second[share] / n - mean * mean) / (n - 1);
        return Estimate{mean, std::sqrt(variance)};
    };
    return {.back = estimate(Back),
            .through = estimate(Through),
            .escape = estimate(Escape),
            .absorbed = estimate(Absorbed),
            .roulette = estimate(Roulette),
            .collisions = estimate(Collisions),
            .paths = paths,
            .leaks = sums.leaks};
}

EnergyBalance measure(const Setting& setting, const EnergyRun& run) {
    const std::uint64_t batches = batches_of(run.paths);
    EXPECTS(batches > 1);
    const std::uint64_t groups = (batches + batches_in_group - 1) / batches_in_group;
    std::vector<Sums> of_group(groups);
    tbb::parallel_for(std::uint64_t{0}, groups,
                      [&](std::uint64_t g) { of_group[g] = group_sums(setting, run, g); });
    Sums all;
    for (const auto& sums : of_group) { // in order: the same digits for any number of threads
        for (std::size_t i = 0; i < shares; ++i) {
            all.first[i] += sums.first[i];
            all.second[i] += sums.second[i];
        }
        all.leaks += sums.leaks;
    }
    return balance_of(all, batches, batches << log2_batch_of(run.paths));
}

/// Downward, cosine-distributed about the normal z.
glm::dvec3 incident_direction(Incidence incidence, PathRandom& random) {
    if (incidence == Incidence::Normal)
        return {0, 0, -1};
    const double u = random.next();
    return around({0, 0, -1}, std::sqrt(1 - u), random.next());
}

/// On a slab's upper surface; through it when that is smooth, so that what it reflects at once can
/// be told apart.
Start slab_start(const EnergyProblem& problem) {
    return [=](PathRandom& random, BodyTracer&) {
        Path<1> path;
        path.direction = incident_direction(problem.incidence, random);
        if (problem.boundary.kind == BoundaryKind::Smooth) {
            path.weight[0] = 1 - fresnel(-path.direction.z, problem.index);
            const auto behind = refracted(path.direction, {0, 0, 1}, problem.index);
            path.direction = behind.value_or(path.direction); // weight 0 where there is none
            path.is_inside = true;
        }
        return std::optional(path);
    };
}

double slab_specular(const EnergyProblem& problem) {
    if (problem.boundary.kind != BoundaryKind::Smooth)
        return 0;
    return problem.incidence == Incidence::Normal ? fresnel(1, problem.index)
                                                  : diffuse_fresnel(problem.index);
}

Start sphere_start(const EnergyProblem& problem) {
    const double radius = problem.optical_thickness;
    return [radius, incidence = problem.incidence](PathRandom& random, BodyTracer&) {
        Path<1> path;
        if (incidence == Incidence::Diffuse) { // every point sees the same: take the pole
            path.position = {0, 0, radius};
            path.direction = incident_direction(incidence, random);
            return std::optional(path);
        }
        const double u = random.next(), turn = 2 * std::numbers::pi * random.next();
        const double x = radius * std::sqrt(u);
        path.position = {x * std::cos(turn), x * std::sin(turn), 2 * radius};
        path.direction = {0, 0, -1};
        return std::optional(path);
    };
}

/// Uniform over all lines through a sphere; nothing when the line misses the body in it.
Start line_start(glm::dvec3 centre, double radius) {
    return [=](PathRandom& random, BodyTracer& tracer) -> std::optional<Path<1>> {
        const double u = random.next(), v = random.next();
        const double r = radius * std::sqrt(random.next()), turn = random.next();
        Path<1> path;
        path.direction = around({0, 0, 1}, 1 - 2 * u, v);
        path.position = centre - 2 * radius * path.direction + r * around(path.direction, 0, turn);
        if (tracer.along(path.position, path.direction, Side::Outside).empty())
            return std::nullopt;
        return path;
    };
}

void check(const EnergyProblem& problem) {
    EXPECTS(problem.optical_thickness > 0);
    EXPECTS(problem.index > 0);
}

} // namespace

EnergyBalance slab_energy(const EnergyProblem& problem, const EnergyRun& run) {
    check(problem);
    const auto body = make_slab(problem.optical_thickness);
    const Medium medium = grey_medium(1, problem.albedo, problem.anisotropy, problem.index);
    auto balance = measure({*body, medium, problem.boundary, {0, 0, -1}, slab_start(problem)}, run);
    balance.specular = slab_specular(problem);
    return balance;
}

EnergyBalance sphere_energy(const EnergyProblem& problem, const EnergyRun& run) {
    check(problem);
    const auto body = make_sphere(problem.optical_thickness);
    const Medium medium = grey_medium(1, problem.albedo, problem.anisotropy, problem.index);
    return measure({*body, medium, problem.boundary, {0, 0, -1}, sphere_start(problem)}, run);
}

EnergyBalance body_energy(const Body& body,
                          glm::dvec3 centre,
                          double radius,
                          const Medium& medium,
                          const Boundary& boundary,
                          const EnergyRun& run) {
    return measure({body, medium, boundary, {0, 0, -1}, line_start(centre, radius)}, run);
}

double
expected_collisions(const geometry::Mesh& mesh, const Medium& medium, const Boundary& boundary) {
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area += 0.5 * glm::length(glm::cross(mesh.positions[b] - mesh.positions[a],
                                             mesh.positions[c] - mesh.positions[a]));
    EXPECTS(area > 0);
    const double index = boundary.kind == BoundaryKind::Matched ? 1 : medium.index;
    const double most =
        std::max({extinction(medium, 0), extinction(medium, 1), extinction(medium, 2)});
    return most * index * index * 4 * std::abs(geometry::signed_volume(mesh)) / area;
}

} // namespace renderer::reference
