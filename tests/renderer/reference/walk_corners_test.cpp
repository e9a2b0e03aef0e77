// Where a walk could stumble: the ends of its random numbers, scattering almost straight on,
// indices at and below one, rays through corners, triangles a rounding wide.
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/reference/energy.h"
#include "renderer/reference/flight.h"
#include "renderer/reference/illumination.h"
#include "renderer/reference/mesh_body.h"
#include "renderer/reference/microfacets.h"
#include "renderer/reference/phase.h"
#include "renderer/reference/walk.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace {

using namespace renderer::reference;
namespace geometry = renderer::geometry;

constexpr Boundary matched{}, smooth{BoundaryKind::Smooth};

// The greatest number of the generator and the greatest float below 1: 32 and 24 factors of two.
constexpr double greatest_drawn = 1 - 0x1p-32, greatest_float = 1 - 0x1p-24;

TEST(Flight, IsFiniteAtBothEndsOfTheRandomNumbers) {
    EXPECT_EQ(flight_length(0, 3), 0);
    EXPECT_DOUBLE_EQ(flight_length(greatest_float, 2), 24 * std::numbers::ln2 / 2);
    EXPECT_DOUBLE_EQ(flight_length(greatest_drawn, 1), 32 * std::numbers::ln2);
    EXPECT_DOUBLE_EQ(flight_length(0x1p-32, 1), 0x1p-32 + 0x1p-65); // u + u^2 / 2
    EXPECT_TRUE(std::isinf(flight_length(0, 0)));
}

TEST(Directions, AreUnitAtBothEndsOfTheRandomNumbers) {
    const glm::dvec3 up{0, 0, 1};
    const Sun sun{.half_angle = renderer::from_degrees(2)};
    for (const double u : {0.0, greatest_float, greatest_drawn})
        for (const double v : {0.0, greatest_float, greatest_drawn}) {
            for (const double g : {-0.999, 0.0, 0.999})
                EXPECT_NEAR(glm::length(around(up, sample_henyey_greenstein(u, g), v)), 1, 1e-14);
            EXPECT_NEAR(glm::length(on_sphere(u, v)), 1, 1e-13); // a step of Newton's from float
            EXPECT_NEAR(glm::length(sample(sun, u, v)), 1, 1e-14);
            for (const double index : {1.5, 1 / 1.5})
                for (const double w : {0.0, greatest_float, greatest_drawn}) {
                    const auto s = sample_rough({up, 0.1, index},
                                                glm::normalize(glm::dvec3(1, 0, 1)), u, v, w);
                    if (s) { // else hidden, which may be
                        EXPECT_NEAR(glm::length(s->direction), 1, 1e-9);
                        EXPECT_TRUE(s->unhidden >= 0 && s->unhidden <= 1);
                    }
                }
        }
}

/// How much a path turns from one flight to the next.
class TurnTally final : public WalkEvents<1> {
  public:
    void collided(const Path<1>& path, const Spectrum<1>&, PathRandom&) override {
        if (path.collisions > 1) {
            const double cosine = glm::dot(last_, path.direction);
            sum += cosine;
            squares += cosine * cosine;
            ++turns;
        }
        last_ = path.direction;
        is_finite =
            is_finite && std::isfinite(glm::length(path.position)) && std::isfinite(path.weight[0]);
    }

    void met_surface(const Path<1>&, const RoughSurface&, PathRandom&) override {}

    void gambled(const Spectrum<1>&) override {}

    void leaked() override { ++lost; }

    void escaped(const Path<1>&) override { ++lost; }

    double sum = 0, squares = 0, turns = 0;
    bool is_finite = true;
    int lost = 0;

  private:
    glm::dvec3 last_{};
};

// Too deep in a half-space to get out before roulette ends the path: no turn is left out for where
// it led.  8 values of g, 4 standard errors: one run in 2000 would fail by chance, the seed is
// fixed.
TEST(Walk, TurnsByTheMeanCosineThatWasAsked) {
    const auto body = make_slab(std::numeric_limits<double>::infinity());
    const auto tracer = body->tracer();
    for (const double g : {-0.999, -0.9, 0.0, 1e-8, 0.49, 0.5, 0.9, 0.999}) {
        TurnTally tally;
        const Medium medium = grey_medium(1, 0.9, g, 1);
        Walk<1> walk(medium, matched, *body, *tracer, tally);
        for (std::uint32_t i = 0; i < 1000; ++i) {
            PathRandom random({7, i, 0, 0, 0});
            walk.start({.position = {0, 0, -1e6}, .is_inside = true});
            walk.follow(random);
        }
        ASSERT_GT(tally.turns, 30'000);
        EXPECT_EQ(tally.lost, 0);
        EXPECT_TRUE(tally.is_finite);
        const double mean = tally.sum / tally.turns;
        const double error = std::sqrt((tally.squares / tally.turns - mean * mean) / tally.turns);
        EXPECT_LE(std::abs(mean - g), 4 * error) << g;
    }
}

TEST(Walk, StaysFiniteWhereLightHardlyTurns) {
    const auto mesh = make_mesh_body(geometry::sphere(1, 3));
    for (const double g : {-0.999, 0.999})
        for (const auto& [boundary, index] : {std::pair{matched, 1.0}, {smooth, 1.4}}) {
            const EnergyRun run{.paths = 1 << 13};
            for (const auto& b :
                 {slab_energy({1, g, 5, index, boundary}, run),
                  body_energy(*mesh, {}, 1, grey_medium(5, 1, g, index), boundary, run)}) {
                EXPECT_NEAR(b.escape.value + b.specular + b.roulette.value, 1, 1e-12);
                EXPECT_TRUE(std::isfinite(b.collisions.value));
                EXPECT_EQ(b.leaks, 0u);
            }
        }
}

// A surface between equal indices is none: the same bits, from the same random numbers.
TEST(Index, OfExactlyOneDrawsNoNumberAndTurnsNothing) {
    for (const auto kind : {BoundaryKind::Smooth, BoundaryKind::Rough}) {
        const EnergyProblem none{0.9, 0.3, 2, 1, matched, Incidence::Diffuse};
        auto one = none;
        one.boundary = {kind};
        const auto a = sphere_energy(none, {.paths = 4096}),
                   b = sphere_energy(one, {.paths = 4096});
        EXPECT_EQ(a.escape.value, b.escape.value);
        EXPECT_EQ(a.through.value, b.through.value);
        EXPECT_EQ(a.collisions.value, b.collisions.value);
    }
}

// What enters a black bubble of gas is gone; what is left is the outer reflection, total
// beyond 41.8 degrees: 1 - (1 - 0.0917780) / 1.5^2 of diffuse light.
TEST(Index, BelowOneReflectsWhatTheIdentitySays) {
    const double exact = 1 - (1 - 0.0917780) / 2.25;
    const auto b =
        sphere_energy({0, 0, 1000, 1 / 1.5, smooth, Incidence::Diffuse}, {.paths = 1 << 16});
    EXPECT_LE(std::abs(b.escape.value - exact), 4 * b.escape.standard_error + 1e-7);
    EXPECT_LE(b.escape.standard_error, 1e-2 * exact);
}

/// A square tower, one of whose edges is split into two that are `gap` apart: the facet between
/// them, and a piece of each end, are needles.
geometry::Mesh needle_tower(double gap) {
    const std::vector<glm::dvec2> outline{{-1, -1}, {1, -1}, {1, 1 - gap}, {1, 1}, {-1, 1}};
    const auto n = static_cast<std::uint32_t>(outline.size());
    geometry::Mesh mesh;
    for (const double z : {-1.0, 1.0})
        for (const auto& p : outline)
            mesh.positions.emplace_back(p, z);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        mesh.triangles.push_back({i, j, n + j});
        mesh.triangles.push_back({i, n + j, n + i});
    }
    for (std::uint32_t i = 1; i + 1 < n; ++i) {
        mesh.triangles.push_back({0, i + 1, i});
        mesh.triangles.push_back({n, n + i, n + i + 1});
    }
    return mesh;
}

/// Vertices, middles of edges and of triangles.
std::vector<glm::dvec3> corners_of(const geometry::Mesh& mesh) {
    auto points = mesh.positions;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
        points.push_back(0.5 * (p + q));
        points.push_back(0.5 * (q + r));
        points.push_back((p + q + r) / 3.0);
    }
    return points;
}

/// Directions along axes and diagonals, where rays run in faces and through edges, and others.
std::vector<glm::dvec3> awkward_directions() {
    std::vector<glm::dvec3> directions;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0)
                    directions.push_back(glm::normalize(glm::dvec3(x, y, z)));
    for (std::uint32_t i = 0; i < 6; ++i) {
        PathRandom random({3, i, 0, 0, 0});
        const double cosine = 2 * random.next() - 1;
        directions.push_back(around({0, 0, 1}, cosine, random.next()));
    }
    return directions;
}

/// What comes out again of light that is not absorbed, but for what roulette took or gave.
class EscapeTally final : public WalkEvents<1> {
  public:
    void collided(const Path<1>&, const Spectrum<1>&, PathRandom&) override {}

    void met_surface(const Path<1>&, const RoughSurface&, PathRandom&) override {}

    void gambled(const Spectrum<1>& change) override { light -= change[0]; }

    void leaked() override { ++leaks; }

    void escaped(const Path<1>& path) override { light += path.weight[0]; }

    double light = 0;
    int leaks = 0;
};

/// Whether the way from the surface leads into a body that is convex for 0.4 around, and not along
/// a face.
bool leads_inside(BodyTracer& tracer, glm::dvec3 point, glm::dvec3 direction) {
    const glm::dvec3 ahead = point + 0.4 * direction;
    const auto stretches = tracer.along(ahead, direction, Side::Unknown);
    return tracer.clearance(ahead) > 0 && !stretches.empty() && stretches.front().begin == 0;
}

/// Toward every corner from afar and from every corner inward, in all awkward directions.
std::vector<Path<1>> awkward_paths(const geometry::Mesh& mesh, BodyTracer& tracer) {
    std::vector<Path<1>> paths;
    for (const auto& point : corners_of(mesh))
        for (const auto& direction : awkward_directions()) {
            paths.push_back({.position = point - 4.0 * direction, .direction = direction});
            if (leads_inside(tracer, point, direction))
                paths.push_back({.position = point, .direction = direction, .is_inside = true});
        }
    return paths;
}

EscapeTally
walk_all(const geometry::Mesh& mesh, const Medium& medium, const Boundary& boundary, int& paths) {
    const auto body = make_mesh_body(mesh);
    const auto tracer = body->tracer();
    EscapeTally tally;
    Walk<1> walk(medium, boundary, *body, *tracer, tally);
    std::uint32_t number = 0;
    for (const auto& path : awkward_paths(mesh, *tracer)) {
        PathRandom random({1, number++, 0, 0, 0});
        walk.start(path);
        walk.follow(random);
    }
    paths = static_cast<int>(number);
    return tally;
}

geometry::Mesh cube() {
    return geometry::slab(2, 2, 2, 1);
}

// One rounding of the float in which rays are traced; the tower's diameter is 2 sqrt(3).
geometry::Mesh narrow_tower() {
    return needle_tower(0x1p-25 * 2 * std::sqrt(3.0));
}

TEST(NeedleTower, KeepsItsNeedlesInFloat) {
    const geometry::RayScene scene(narrow_tower());
    const auto p = scene.positions();
    EXPECT_EQ(p[2].y, std::nextafter(p[3].y, 0.0f));
}

/// Two faces that meet at 1 degree.
geometry::Mesh wedge() {
    const double half = 2 * std::tan(0.5 * std::numbers::pi / 180);
    geometry::Mesh mesh;
    for (const double z : {-1.0, 1.0})
        for (const auto& [x, y] : {std::pair{0.0, 0.0}, {2.0, -half}, {2.0, half}})
            mesh.positions.emplace_back(x, y, z);
    mesh.triangles = {{0, 2, 1}, {3, 4, 5}};
    for (const auto& [i, j] : {std::pair{0u, 1u}, {1u, 2u}, {2u, 0u}}) {
        mesh.triangles.push_back({i, j, 3 + j});
        mesh.triangles.push_back({i, 3 + j, 3 + i});
    }
    return mesh;
}

/// Side by side: their faces lie in the same planes, with nothing in between.
geometry::Mesh two_cubes() {
    geometry::Mesh both = cube();
    const auto n = static_cast<std::uint32_t>(both.positions.size());
    for (const auto& p : cube().positions)
        both.positions.push_back(p + glm::dvec3(3, 0, 0));
    for (const auto& [a, b, c] : cube().triangles)
        both.triangles.push_back({n + a, n + b, n + c});
    return both;
}

TEST(Walk, LosesNothingOutOfNeedles) {
    for (const auto& mesh : {cube(), narrow_tower(), wedge(), geometry::sphere(1, 1)})
        for (const auto& [boundary, index] : {std::pair{matched, 1.0}, {smooth, 1.4}}) {
            const auto bounds = geometry::bounding_sphere(mesh);
            const auto b = body_energy(*make_mesh_body(mesh), bounds.centre, bounds.radius,
                                       grey_medium(1, 1, 0, index), boundary, {.paths = 1 << 14});
            EXPECT_NEAR(b.escape.value + b.roulette.value, 1, 1e-12);
            EXPECT_EQ(b.leaks, 0u);
        }
}

TEST(Walk, LosesNothingAtVerticesEdgesAndNeedles) {
    const Boundary rough{BoundaryKind::Rough, 0.3};
    for (const auto& mesh : {cube(), narrow_tower(), wedge(), two_cubes(), geometry::sphere(1, 1)})
        for (const auto& [boundary, index] :
             {std::pair{matched, 1.0}, {smooth, 1.4}, {rough, 1.4}}) {
            int paths = 0;
            const auto tally = walk_all(mesh, grey_medium(1, 1, 0, index), boundary, paths);
            EXPECT_EQ(tally.leaks, 0) << mesh.triangles.size() << ' ' << name_of(boundary.kind);
            EXPECT_NEAR(tally.light, paths, 1e-9 * paths);
            EXPECT_GT(paths, 900);
        }
}

// Through the face that is not there, paths get out unseen; each is found out and counted, and
// nothing but its light is missing.
TEST(Walk, CountsWhatAMissingFaceLoses) {
    geometry::Mesh open = cube();
    std::erase_if(open.triangles, [&](const geometry::Triangle& t) {
        return std::ranges::all_of(t, [&](auto v) { return open.positions[v].z > 0; });
    });
    ASSERT_EQ(open.triangles.size(), cube().triangles.size() - 2);
    int paths = 0;
    const auto tally = walk_all(open, grey_medium(1, 1, 0, 1.4), smooth, paths);
    EXPECT_GT(tally.leaks, paths / 100);
    EXPECT_NEAR(tally.light, paths - tally.leaks, 1e-9 * paths);
}

} // namespace
