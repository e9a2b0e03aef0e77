// Laws that hold for any body, and the corners where a walk could stumble.
#include "renderer/geometry/bodies.h"
#include "renderer/reference/clearance.h"
#include "renderer/reference/energy.h"
#include "renderer/reference/mesh_body.h"
#include "renderer/reference/sunward_depth.h"
#include "renderer/reference/walk.h"
#include "tests/renderer/geometry/assembly.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace {

using namespace renderer::reference;

constexpr Boundary matched{}, smooth{BoundaryKind::Smooth};

/// |estimate - exact| in standard errors.
double deviation(const Estimate& estimate, double exact) {
    return std::abs(estimate.value - exact) / estimate.standard_error;
}

TEST(Energy, IsNeitherMadeNorLost) {
    for (const auto& boundary : {matched, smooth})
        for (const double albedo : {0.0, 0.5, 0.999, 1.0})
            for (const double g : {0.0, 0.9}) {
                const auto b = slab_energy({albedo, g, 3, 1.4, boundary}, {.paths = 4096});
                const double all = b.back.value + b.through.value + b.absorbed.value +
                                   b.roulette.value + b.specular;
                EXPECT_NEAR(all, 1, 1e-12) << albedo << ' ' << g;
                EXPECT_EQ(b.leaks, 0u);
            }
}

TEST(Roulette, ChangesNothingOnAverage) {
    const auto b = slab_energy({0.95, 0, 20, 1, matched},
                               {.paths = 1 << 16, .tactics = {.roulette_after = 4}});
    EXPECT_GT(b.roulette.standard_error, 0);
    EXPECT_LE(deviation(b.roulette, 0), 4);
    const auto early = slab_energy({0.95, 0, 20, 1, matched}, {.paths = 1 << 16, .seed = 2});
    EXPECT_LE(std::abs(b.back.value - early.back.value),
              4 * std::hypot(b.back.standard_error, early.back.standard_error));
}

// Without absorption, under even light, a path has index^2 4V/S of body on average, whatever
// scatters in it: 4/3 radii of a sphere.  [Blanco2003] [Tommasi2020]
TEST(MeanPath, DependsOnTheShapeAlone) {
    for (const auto& [g, index] : {std::pair{0.0, 1.0}, {0.8, 1.0}, {0.0, 1.3}, {0.5, 1.5}}) {
        EnergyProblem problem{1, g, 1, index, index == 1 ? matched : smooth, Incidence::Diffuse};
        const auto b = sphere_energy(problem, {.paths = 1 << 17});
        EXPECT_LE(deviation(b.collisions, 4.0 / 3 * index * index), 4) << g << ' ' << index;
        EXPECT_NEAR(b.escape.value, 1, 1e-12);
        // known beforehand: V/S of a sphere of triangles is 1e-3 smaller at 5 subdivisions
        EXPECT_NEAR(expected_collisions(renderer::geometry::sphere(1, 5),
                                        grey_medium(1, 1, g, index), problem.boundary),
                    4.0 / 3 * index * index, 2e-3 * index * index);
    }
}

// [1 - (1 + 2x) e^-2x] / (2 x^2) of even light gets through a pure absorber of optical radius x.
TEST(PureAbsorber, LetsThroughWhatItsChordsDo) {
    for (const auto& [x, exact] :
         {std::pair{0.5, 0.528482}, {1.0, 0.296997}, {2.0, 0.113553}, {5.0, 0.019990}}) {
        const std::uint64_t paths = x < 5 ? 1 << 16 : 1 << 20; // little light gets through
        const auto b = sphere_energy({0, 0, x, 1, matched, Incidence::Diffuse}, {.paths = paths});
        EXPECT_LE(std::abs(b.escape.value - exact), 4 * b.escape.standard_error + 5e-7) << x;
        EXPECT_LE(b.escape.standard_error, 1e-3 * exact);
    }
}

// Beer and Lambert on the refracted chord: every inner reflection meets the surface at one angle.
TEST(PureAbsorber, BehindASmoothBoundaryFollowsRefractedChords) {
    constexpr double index = 1.5, x = 0.7;
    double exact = 0;
    constexpr int n = 20000; // midpoints in sin^2
    for (int i = 0; i < n; ++i) {
        const double cosine = std::sqrt(1 - (i + 0.5) / n);
        const double inner = std::sqrt(1 - (1 - cosine * cosine) / (index * index));
        const double f = fresnel(cosine, index), pass = std::exp(-2 * x * inner);
        exact += (f + (1 - f) * (1 - f) * pass / (1 - f * pass)) / n;
    }
    const auto b = sphere_energy({0, 0, x, index, smooth, Incidence::Diffuse}, {.paths = 1 << 18});
    EXPECT_LE(deviation(b.escape, exact), 4);
}

TEST(DeepBody, WithHardlyAnyAbsorptionStillGlowsLikeAFurnace) {
    // 1 - albedo = 1e-6 over 100 mean free paths: 133 collisions on average, each loses 1e-6
    const auto b =
        sphere_energy({1 - 1e-6, 0, 100, 1, matched, Incidence::Diffuse}, {.paths = 8192});
    EXPECT_NEAR(b.escape.value + b.absorbed.value + b.roulette.value, 1, 1e-12);
    EXPECT_NEAR(b.escape.value, 1, 1e-3);
    EXPECT_LE(deviation(b.collisions, 400.0 / 3), 4);
}

TEST(GasBubble, ReflectsTotallyOutside) {
    const auto b =
        sphere_energy({1, 0, 1, 1 / 1.5, smooth, Incidence::Diffuse}, {.paths = 1 << 15});
    EXPECT_NEAR(b.escape.value, 1, 1e-12);
    EXPECT_LE(deviation(b.collisions, 4.0 / 3 / 2.25), 4);
}

/// What escapes, channel by channel.
class ColourTally final : public WalkEvents<3> {
  public:
    void collided(const Path<3>&, const Spectrum<3>&, PathRandom&) override {}

    void met_surface(const Path<3>&, const RoughSurface&, PathRandom&) override {}

    void gambled(const Spectrum<3>&) override {}

    void leaked() override { ++leaks; }

    void escaped(const Path<3>& path) override {
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += path.weight[k];
    }

    Spectrum<3> sum{};
    int leaks = 0;
};

// Three colours at once against one at a time; one colour sees nothing at all, one only absorbs.
TEST(Colours, WalkedTogetherAreThoseWalkedAlone) {
    Medium medium{{0.05, 0, 1}, {0.95, 0, 0}, 0.2, 1.3};
    for (const auto& boundary : {matched, smooth})
        for (const bool forced : {false, true}) {
            const auto body = make_sphere(2);
            const auto tracer = body->tracer();
            ColourTally tally;
            Walk<3> walk(medium, boundary, *body, *tracer, tally, {.force_first = forced});
            constexpr int batches = 256;
            Spectrum<3> mean{}, squares{};
            for (std::uint32_t b = 0; b < batches; ++b) {
                tally.sum = {};
                for (std::uint32_t s = 0; s < 64; ++s) {
                    PathRandom random({5, 0, b, s, 6});
                    Path<3> path;
                    path.position = {0, 0, 2};
                    const double u = random.next();
                    const double c = std::sqrt(1 - u), t = 6.283185307179586 * random.next();
                    path.direction = {std::sqrt(u) * std::cos(t), std::sqrt(u) * std::sin(t), -c};
                    walk.start(path);
                    walk.follow(random);
                }
                for (std::size_t k = 0; k < 3; ++k) {
                    const double x = tally.sum[k] / 64;
                    mean[k] += x / batches;
                    squares[k] += x * x / batches;
                }
            }
            const auto alone = [&](double albedo, double depth) {
                return sphere_energy({albedo, 0.2, depth, 1.3, boundary, Incidence::Diffuse},
                                     {.paths = 1 << 17});
            };
            const std::array<Estimate, 3> exact{alone(0.95, 2).escape, Estimate{1, 0},
                                                alone(0, 2).escape};
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_TRUE(std::isfinite(mean[k]));
                const double se =
                    std::sqrt(std::max(0.0, squares[k] - mean[k] * mean[k]) / batches);
                EXPECT_LE(std::abs(mean[k] - exact[k].value),
                          4 * std::hypot(se, exact[k].standard_error) + 1e-12)
                    << k << ' ' << forced;
            }
            EXPECT_EQ(tally.leaks, 0);
        }
}

TEST(Clearance, NeverExceedsTheDistanceFromASphere) {
    const renderer::geometry::RayScene scene(renderer::geometry::sphere(1, 4));
    const Clearance clearance(scene, 32);
    double greatest_loss = 0;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        PathRandom random({1, i, 0, 0, 0});
        const glm::dvec3 p =
            0.49 * (2.0 * glm::dvec3(random.next(), random.next(), random.next()) - 1.0);
        const double distance = 0.5 - glm::length(p); // vertices are on the sphere,
        const double bound = static_cast<double>(clearance.at(glm::vec3(p)));
        EXPECT_LE(bound, std::abs(distance) + 1e-6); // faces inside it: outside is farther
        greatest_loss = std::max(greatest_loss, std::abs(distance) - bound);
        EXPECT_TRUE(!clearance.is_surely_outside(glm::vec3(p)) || distance < 0.004);
    }
    EXPECT_TRUE(clearance.is_surely_outside({0.45f, 0.45f, 0}));
    // two cells' diagonals, and a quarter of a cell that is rounded down
    EXPECT_LE(greatest_loss, (2 * std::sqrt(3.0) + 0.25) / 32 + 0.002);
    EXPECT_EQ(clearance.at({2, 0, 0}), 0);
}

// A shell: nothing in its cavity or around it is inside, and most of what is between is known.
TEST(Clearance, KnowsOnlyInsidesThatAre) {
    const renderer::geometry::RayScene scene(renderer::geometry::shell(1, 0.5, 4));
    const Clearance clearance(scene);
    int insides = 0, known = 0;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        PathRandom random({1, i, 0, 0, 0});
        const glm::dvec3 p = glm::dvec3(random.next(), random.next(), random.next()) - 0.5;
        const double r = glm::length(p); // faces are up to 0.2 % inside the spheres
        const bool is_known = clearance.is_surely_inside(glm::vec3(p));
        EXPECT_TRUE(!is_known || (r > 0.249 && r < 0.5));
        insides += r > 0.25 && r < 0.499 ? 1 : 0;
        known += is_known ? 1 : 0;
    }
    EXPECT_GT(known, 0.7 * insides);
    EXPECT_FALSE(clearance.is_surely_inside({2, 0, 0}));
}

// Of a concave, hollow body, toward a slanting light: never more than there is, and a good part of
// that; and a guess that is near, or says that it may not be.
TEST(SunwardDepth, KnowsTheLengthInside) {
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(0.3, -0.5, 1));
    for (const auto& mesh :
         {renderer::geometry::shell(2, 1, 3), renderer::geometry::torus(1.4, 0.6, 32, 16)}) {
        const auto body = make_mesh_body(mesh);
        const auto depth = body->sunward_depth(to_light);
        ASSERT_EQ(depth, body->sunward_depth(to_light)); // made once
        const auto tracer = body->tracer();
        double least = 0, there = 0, missed = 0;
        int unaware = 0;
        for (std::uint32_t i = 0; i < 20000; ++i) {
            PathRandom random({1, i, 0, 0, 0});
            const glm::dvec3 p =
                4.4 * glm::dvec3(random.next() - 0.5, random.next() - 0.5, random.next() - 0.5);
            const double length = interior_length(*tracer, p, to_light);
            const auto guess = depth->at(p);
            EXPECT_LE(guess.least, length + 1e-6);
            const double error = std::abs(guess.likely - length);
            least += guess.least;
            there += length;
            missed += guess.spread < std::numeric_limits<double>::max() ? error : 0; // in the grid
            unaware += error > guess.spread + 0.01 ? 1 : 0;
        }
        EXPECT_GT(least, 0.4 * there); // cells of a sixteenth of a body's thickness
        // A cell is a sixteenth of the shell's thickness: interpolated depths err by its square.
        EXPECT_LT(missed, 0.02 * there);
        EXPECT_LT(unaware, 200); // of 20,000: no guess costs more than a ray that comes too seldom
    }
}

// A sphere of triangles approaches the true one: at 5 subdivisions it is 0.06 % smaller.
TEST(MeshBody, WalksLikeTheBodyItApproximates) {
    const auto mesh = make_mesh_body(renderer::geometry::sphere(3, 5));
    for (const auto& [boundary, index] : {std::pair{matched, 1.0}, {smooth, 1.5}}) {
        const auto medium = grey_medium(1, 0.9, 0, index);
        const auto traced = body_energy(*mesh, {}, 3, medium, boundary, {.paths = 1 << 16});
        const auto exact =
            sphere_energy({0.9, 0, 3, index, boundary, Incidence::Diffuse}, {.paths = 1 << 17});
        EXPECT_LE(std::abs(traced.escape.value - exact.escape.value),
                  4 * std::hypot(traced.escape.standard_error, exact.escape.standard_error) + 5e-4);
        EXPECT_EQ(traced.leaks, 0u);
    }
}

// Concave, nested, overlapping: an even sky comes through a body that only scatters as it is.
TEST(Furnace, OfAnyBodyShowsTheSkyAndLeaksNothing) {
    using namespace renderer::geometry;
    const std::array<Mesh, 4> meshes{
        shell(1, 0.5, 3), torus(0.7, 0.3, 32, 16), slab(2, 2, 0.2, 4),
        together(slab(2, 2, 2, 1), moved(slab(2, 2, 2, 1), {1, 0.1, 0.1}))};
    for (const auto& mesh : meshes)
        for (const auto& [boundary, index] : {std::pair{matched, 1.0}, {smooth, 1.4}}) {
            const auto body = make_mesh_body(mesh);
            const auto bounds = bounding_sphere(mesh);
            const auto b = body_energy(*body, bounds.centre, bounds.radius,
                                       grey_medium(4, 1, 0.3, index), boundary, {.paths = 1 << 14});
            EXPECT_NEAR(b.escape.value + b.roulette.value, 1, 1e-12);
            EXPECT_GT(b.collisions.value, 1);
            EXPECT_EQ(b.leaks, 0u);
        }
}

} // namespace
