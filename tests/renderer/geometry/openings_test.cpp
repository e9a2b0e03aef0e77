#include "renderer/geometry/bodies.h"
#include "renderer/geometry/crossings.h"
#include "renderer/geometry/mesh_report.h"
#include "renderer/geometry/openings.h"
#include "renderer/geometry/winding.h"
#include "renderer/harmonics/directions.h"
#include "tests/renderer/geometry/assembly.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace {

using namespace renderer::geometry;

// Scene units are diameters in float: a length is right to about 1e-6 of the diameter.
constexpr double float_lengths = 4e-6;

Mesh without(Mesh mesh, const std::function<bool(glm::dvec3 middle)>& is_gone) {
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
        return is_gone((mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0);
    });
    return mesh;
}

double total(std::span<const Segment> segments) {
    double sum = 0;
    for (const auto& [begin, end] : segments)
        sum += end - begin;
    return sum;
}

/// A mesh with openings, and rays through it.
struct Opened {
    explicit Opened(const Mesh& mesh)
        : covered(cover_openings(mesh)), scene(covered.mesh),
          interior(scene, covered.own_triangles), tracer(scene, interior) {}

    CoveredMesh covered;
    RayScene scene;
    OpenInterior interior;
    InteriorTracer tracer;
};

TEST(Openings, OfAClosedMeshAreNone) {
    const Mesh ball = sphere(1, 2);
    const auto covered = cover_openings(ball);
    EXPECT_EQ(covered.mesh.triangles, ball.triangles);
    EXPECT_EQ(covered.mesh.positions.size(), ball.positions.size());
}

TEST(Openings, AreCoveredSoThatTheSurfaceIsClosed) {
    const Mesh cup = without(torus(1, 0.4, 24, 12), [](glm::dvec3 p) {
        return glm::length(p - glm::dvec3(1, 0, 0.4)) < 0.4 || p.x < -0.9;
    });
    const auto report = examine(cup);
    EXPECT_GT(report.boundary.count, 10u);
    EXPECT_TRUE(is_oriented_but_for_openings(report));
    EXPECT_TRUE(is_closed_and_oriented(examine(cover_openings(cup).mesh)));
}

// Two of the cube's holes share a corner: one rim, one apex.
TEST(Openings, ThatTouchAreCoveredToo) {
    const Mesh cube =
        without(slab(2, 2, 2, 2), [](glm::dvec3 p) { return p.z > 0.999 && p.x * p.y > 0; });
    const auto covered = cover_openings(cube);
    EXPECT_TRUE(is_closed_and_oriented(examine(covered.mesh)));
    EXPECT_NEAR(signed_volume(covered.mesh), 8, 1e-12);
}

// Around a flat rim the winding number of one half is the flat lid: seen from just above and just
// below, the lid fills half of the sky.
TEST(Openings, WithAFlatRimEndTheInsideLikeALid) {
    const Mesh box = without(slab(2, 2, 2, 8), [](glm::dvec3 p) { return p.z > 0.999; });
    Opened opened(box);
    for (const auto& s : renderer::harmonics::fibonacci_directions(200, 3).directions) {
        const glm::dvec3 p(0.1, -0.2, 0.3);
        const glm::dvec3 to_faces = (glm::sign(s) - p) / s;
        EXPECT_NEAR(total(opened.tracer.from_point(p, s)),
                    std::min({to_faces.x, to_faces.y, to_faces.z}), 2 * float_lengths)
            << s.x << " " << s.y << " " << s.z;
    }
    const auto through = opened.tracer.from_point({0.3, 0.2, 5}, {0, 0, -1});
    ASSERT_EQ(through.size(), 1u);
    EXPECT_NEAR(through[0].begin, 4, float_lengths);
    EXPECT_NEAR(through[0].end, 6, float_lengths);
    EXPECT_GT(opened.tracer.statistics().past_openings, 0u);
    EXPECT_EQ(opened.tracer.statistics().fallbacks, 0u);
}

// The rule itself, asked along the ray: 1,000 places on each of 150 rays, summed over the surface.
TEST(Openings, AreFollowedWhereTheSurfaceWindsHalfAround) {
    const Mesh bowl = without(sphere(1, 2), [](glm::dvec3 p) {
        return p.z > 0.4 + 0.3 * p.x * p.y || glm::length(p - glm::dvec3(0, -1, 0)) < 0.3;
    });
    Opened opened(bowl);
    const std::vector<glm::vec3> positions(bowl.positions.begin(), bowl.positions.end());
    const auto directions = renderer::harmonics::fibonacci_directions(150, 7).directions;
    constexpr int places = 1000;
    const double reach = 2.5;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const glm::dvec3 p = 0.9 * directions[(37 * i) % directions.size()], s = directions[i];
        int inside = 0;
        for (int k = 0; k < places; ++k)
            inside +=
                winding_number(positions, bowl.triangles, p + (k + 0.5) / places * reach * s) > 0.5
                    ? 1
                    : 0;
        // Each of at most four ends of stretches lies within half a step of a place that was asked.
        EXPECT_NEAR(total(opened.tracer.from_point(p, s)), inside * reach / places,
                    2 * reach / places)
            << i;
    }
}

// Three corners are always in a plane: the winding number puts the triangle back.
TEST(Openings, OfOneTriangleChangeNothing) {
    Mesh pierced = sphere(1, 2);
    const Mesh whole = pierced;
    pierced.triangles.erase(pierced.triangles.begin() + 17);
    Opened opened(pierced);
    const RayScene scene(whole);
    InteriorTracer tracer(scene);
    for (std::uint32_t v = 0; v < whole.positions.size(); ++v)
        for (const auto& s : renderer::harmonics::fibonacci_directions(100, 4).directions)
            ASSERT_NEAR(total(opened.tracer.from_vertex(v, s)), total(tracer.from_vertex(v, s)),
                        2 * float_lengths)
                << v;
    EXPECT_GT(opened.tracer.statistics().past_openings, 0u);
}

// A hole of radius r in a sphere takes at most the lid's height r^2/2 from an end that falls into
// it, over the cosine there; with rays that meet it at 60 degrees or less that is r^2.  The mesh's
// edge moves a rim by half an edge.
TEST(Openings, TakeAwayLessTheSmallerTheyAre) {
    const Mesh whole = sphere(1, 5);
    const RayScene scene(whole);
    InteriorTracer tracer(scene);
    double before = 1;
    for (const double radius : {0.4, 0.2, 0.1}) {
        Opened opened(without(
            whole, [&](glm::dvec3 p) { return glm::length(p - glm::dvec3(0, 0, 1)) < radius; }));
        double largest = 0;
        for (const auto& s : renderer::harmonics::fibonacci_directions(400, 4).directions) {
            if (s.z < 0.5)
                continue;
            for (const auto& p : {glm::dvec3(0, 0, 0), glm::dvec3(0.1, 0.05, -0.3)})
                largest = std::max(largest, std::abs(total(opened.tracer.from_point(p, s)) -
                                                     total(tracer.from_point(p, s))));
        }
        const double rim = radius + 0.02;
        EXPECT_LE(largest, rim * rim) << radius;
        EXPECT_LT(largest, 0.5 * before) << radius;
        before = largest;
    }
    EXPECT_GT(before, 0);
}

/// A cube of edge 2 whose upper face has one edge cut in two where its neighbour's is whole: the
/// corner there lies `gap` beside the neighbour's edge.
Mesh cube_with_t_junction(double gap) {
    Mesh cube;
    cube.positions = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},       {-1, -1, 1},
                      {1, -1, 1},   {1, 1, 1},   {-1, 1, 1}, {0.1, -1 + gap, 1}};
    cube.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7},
                      {2, 7, 6}, {3, 0, 4}, {3, 4, 7}, {8, 5, 6}, {8, 6, 7}, {8, 7, 4}};
    return cube;
}

// Rays along the crack are asked again 1e-5 rad beside.  The ray from below leaves through the
// crack itself, and beside it.
TEST(Openings, AtTJunctionsLeakNothing) {
    constexpr double jittered = 2e-5;
    for (const double gap : {0.0, 1e-6}) {
        const Mesh cube = cube_with_t_junction(gap);
        EXPECT_EQ(examine(cube).boundary.count, 3u);
        Opened opened(cube);
        for (const double x : {-0.9, -0.3, 0.1, 0.1000001, 0.5})
            for (const double depth : {0.0, 0.5 * gap, gap, 2 * gap, 1e-4}) {
                const auto up = opened.tracer.from_point({x, -1 + depth, -3}, {0, 0, 1});
                const bool grazes = depth <= gap + 1e-7;
                if (!grazes || !up.empty()) {
                    EXPECT_NEAR(total(up), 2, float_lengths) << x << " " << depth;
                }
                const glm::dvec3 exit(x, -1 + depth, 1);
                EXPECT_NEAR(total(opened.tracer.from_point({0, 0, 0}, glm::normalize(exit))),
                            glm::length(exit), 2 * gap + jittered)
                    << x << " " << depth;
            }
        for (const auto& s : renderer::harmonics::fibonacci_directions(500, 2).directions) {
            const glm::dvec3 to_faces = glm::sign(s) / s;
            EXPECT_NEAR(total(opened.tracer.from_point({0, 0, 0}, s)),
                        std::min({to_faces.x, to_faces.y, to_faces.z}), 2 * gap + float_lengths);
        }
        EXPECT_EQ(opened.tracer.statistics().fallbacks, 0u);
    }
}

} // namespace
