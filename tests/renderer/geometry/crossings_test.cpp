#include "renderer/geometry/bodies.h"
#include "renderer/geometry/crossings.h"
#include "renderer/harmonics/directions.h"
#include "tests/renderer/geometry/assembly.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

namespace {

using namespace renderer::geometry;

const std::array<glm::dvec3, 6> axes{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

double total(std::span<const Segment> segments) {
    double sum = 0;
    for (const auto& [begin, end] : segments)
        sum += end - begin;
    return sum;
}

std::uint32_t vertex_at(const Mesh& mesh, glm::dvec3 place) {
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
        if (glm::distance(mesh.positions[v], place) < 1e-9)
            return v;
    ADD_FAILURE() << "no vertex there";
    return 0;
}

// Scene units are diameters in float: a length is right to about 1e-6 of the diameter.
TEST(Crossings, OfACubeFromAFaceCentreAreTheEdgeLength) {
    const Mesh cube =
        slab(2, 2, 2, 2); // the ray leaves through a vertex, where 4 to 8 triangles meet
    const RayScene scene(cube);
    InteriorTracer tracer(scene);
    const auto segments = tracer.from_vertex(vertex_at(cube, {0, 0, 1}), {0, 0, -1});
    ASSERT_EQ(segments.size(), 1u);
    EXPECT_EQ(segments[0].begin, 0);
    EXPECT_NEAR(segments[0].end, 2, 1e-6);
    EXPECT_TRUE(tracer.from_vertex(vertex_at(cube, {0, 0, 1}), {0, 0, 1}).empty());
}

// Rays along the axes of a cube pass through vertices and edges, and along faces, everywhere.
TEST(Crossings, ThroughEdgesAndVerticesCountOnce) {
    const Mesh cube = slab(2, 2, 2, 4);
    const RayScene scene(cube);
    InteriorTracer tracer(scene);
    int in_the_plane = 0, across = 0;
    for (std::uint32_t v = 0; v < cube.positions.size(); ++v)
        for (const auto& s : axes) {
            const auto p = cube.positions[v];
            const double d = total(tracer.from_vertex(v, s));
            const glm::dvec3 sideways = glm::abs(p) * (1.0 - glm::abs(s));
            if (std::max({sideways.x, sideways.y, sideways.z}) > 1 - 1e-9) {
                // along a face: nothing, or as much of the face as lies ahead
                EXPECT_TRUE(std::abs(d) <= 1e-6 || std::abs(d - (1 - glm::dot(p, s))) <= 1e-4) << d;
                ++in_the_plane;
            } else {
                EXPECT_NEAR(d, 1 - glm::dot(p, s), 2e-6); // 0 or 2
                ++across;
            }
        }
    EXPECT_GT(in_the_plane, 0);
    EXPECT_GT(across, 0);
    EXPECT_EQ(tracer.statistics().fallbacks, 0u);
}

TEST(Crossings, OfDiagonalsThroughEdgesCountOnce) {
    const Mesh cube = slab(2, 2, 2, 4);
    const RayScene scene(cube);
    InteriorTracer tracer(scene);
    const auto s = glm::normalize(glm::dvec3(1, 0, 1)); // from edge to edge
    const auto segments = tracer.from_vertex(vertex_at(cube, {-1, 0.5, -1}), s);
    ASSERT_EQ(segments.size(), 1u);
    EXPECT_NEAR(segments[0].end, 2 * std::sqrt(2), 4e-5); // a jittered ray is 1e-5 rad beside
}

TEST(Crossings, FromAnyPointFindTheStretchesOfAShell) {
    const Mesh mesh = shell(1, 0.5, 4);
    const RayScene scene(mesh);
    InteriorTracer tracer(scene);
    const auto s = glm::normalize(glm::dvec3(1, 0.02, 0.03));
    const auto segments = tracer.from_point(-2.0 * s, s); // outside
    ASSERT_EQ(segments.size(), 2u);
    const double h2 = 0.002; // a facet's depth below the sphere at 4 subdivisions: h^2/8, h = 0.08
    EXPECT_NEAR(segments[0].begin, 1, h2);
    EXPECT_NEAR(segments[0].end, 1.5, h2);
    EXPECT_NEAR(segments[1].begin, 2.5, h2);
    EXPECT_NEAR(segments[1].end, 3, h2);
    const auto from_cavity = tracer.from_point({0, 0, 0}, s);
    ASSERT_EQ(from_cavity.size(), 1u);
    EXPECT_NEAR(from_cavity[0].begin, 0.5, h2);
    const auto from_material = tracer.from_point(-0.75 * s, s);
    ASSERT_EQ(from_material.size(), 2u);
    EXPECT_EQ(from_material[0].begin, 0);
    EXPECT_EQ(tracer.statistics().retried, 0u);
    EXPECT_EQ(tracer.statistics().rays, 3u);
}

TEST(Crossings, OverlappingBodiesCountOnce) {
    const Mesh mesh = together(slab(2, 2, 2, 1), moved(slab(2, 2, 2, 1), {1, 0.1, 0.1}));
    const RayScene scene(mesh);
    InteriorTracer tracer(scene);
    const auto across = tracer.from_point({-3, 0.3, 0.2}, {1, 0, 0});
    ASSERT_EQ(across.size(), 1u);
    EXPECT_NEAR(across[0].begin, 2, 1e-5);
    EXPECT_NEAR(across[0].end, 5, 1e-5);
    const auto from_the_overlap = tracer.from_point({0.5, 0.3, 0.2}, {1, 0, 0});
    ASSERT_EQ(from_the_overlap.size(), 1u);
    EXPECT_NEAR(total(from_the_overlap), 1.5, 1e-4);
    EXPECT_EQ(tracer.statistics().retried,
              1u); // two surfaces around a point: asked twice, confirmed
    EXPECT_EQ(tracer.statistics().fallbacks, 0u);
}

TEST(Crossings, ATurnedOutFoldHoldsNothing) {
    const Mesh mesh = together(slab(2, 2, 2, 1), moved(flipped(slab(1, 1, 1, 1)), {3, 0, 0}));
    const RayScene scene(mesh);
    InteriorTracer tracer(scene);
    const auto segments = tracer.from_point({-2, 0.2, 0.3}, {1, 0, 0});
    ASSERT_EQ(segments.size(), 1u);
    EXPECT_NEAR(segments[0].end, 3, 1e-4);
    EXPECT_EQ(tracer.statistics().retried, 1u);
    EXPECT_EQ(tracer.statistics().fallbacks, 0u);
}

TEST(Crossings, DuplicateTrianglesCountOnce) {
    Mesh mesh = sphere(1, 3);
    const Mesh once = mesh;
    mesh.triangles.insert(mesh.triangles.end(), once.triangles.begin(), once.triangles.end());
    const RayScene scene(mesh), scene_once(once);
    InteriorTracer tracer(scene), tracer_once(scene_once);
    for (const auto& s : renderer::harmonics::fibonacci_directions(50, 2).directions)
        for (std::uint32_t v = 0; v < mesh.positions.size(); v += 7)
            EXPECT_EQ(total(tracer.from_vertex(v, s)), total(tracer_once.from_vertex(v, s)));
}

// Tangent to the body at its own vertex: d = 2R |x| there, next to nothing.  On the mesh the
// tangent plane touches nothing but the vertex; 1e-7 below it a ray still passes above the facets.
TEST(Crossings, GrazingASphereFindNextToNothing) {
    const Mesh mesh = sphere(1, 4);
    const RayScene scene(mesh);
    InteriorTracer tracer(scene);
    for (std::uint32_t v = 0; v < mesh.positions.size(); v += 5) {
        const auto n = mesh.positions[v];
        const auto u = glm::normalize(glm::cross(n, glm::dvec3(0.3, 0.5, 0.8)));
        for (const double x : {1e-7, 0.0, -1e-7}) {
            const double d = total(tracer.from_vertex(v, glm::normalize(u + x * n)));
            EXPECT_GE(d, 0);
            EXPECT_LE(d, 1e-6);
        }
    }
}

// A slit a hair wide swallows the exit of the one ray that finds it: an entry that was never left.
TEST(Crossings, ARayThroughASlitIsAskedAgain) {
    const double gap = 1e-6;
    Mesh mesh; // a square that faces -z at z = 0, and one in two halves that faces +z at z = 1
    mesh.positions = {{-1, -1, 0},  {1, -1, 0},    {1, 1, 0},    {-1, 1, 0},
                      {-1, -1, 1},  {-gap, -1, 1}, {-gap, 1, 1}, {-1, 1, 1},
                      {gap, -1, 1}, {1, -1, 1},    {1, 1, 1},    {gap, 1, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {8, 9, 10}, {8, 10, 11}};
    const RayScene scene(mesh);
    InteriorTracer tracer(scene);
    const auto segments = tracer.from_point({0, 0.1, -1}, {0, 0, 1});
    ASSERT_EQ(segments.size(), 1u);
    EXPECT_NEAR(segments[0].begin, 1, 1e-5);
    EXPECT_NEAR(segments[0].end, 2, 1e-5);
    EXPECT_EQ(tracer.statistics().retried, 1u);
    EXPECT_EQ(tracer.statistics().fallbacks, 0u);
}

// Every triangle by itself, a millionth smaller than its place: a ray through a gap loses a
// crossing.  Gaps are 288 long and 1e-6 wide in an area of 4 pi, so 2.3e-5 of the rays find one; of
// 20,000 rays 0.5 do, and more than 6 with a chance of 1e-7.  All others see what the whole body
// shows, to the width of a gap over the cosine of their exit.
TEST(Crossings, HairlineGapsHardlyEverLeak) {
    const Mesh whole = sphere(1, 3);
    Mesh loose;
    for (const auto& [a, b, c] : whole.triangles) {
        const auto centre = (whole.positions[a] + whole.positions[b] + whole.positions[c]) / 3.0;
        const auto first = static_cast<std::uint32_t>(loose.positions.size());
        for (const auto corner : {a, b, c}) {
            const auto inward = glm::normalize(centre - whole.positions[corner]);
            loose.positions.push_back(whole.positions[corner] + 1e-6 * inward);
        }
        loose.triangles.push_back({first, first + 1, first + 2});
    }
    const RayScene scene(whole), loose_scene(loose);
    InteriorTracer tracer(scene), loose_tracer(loose_scene);
    const auto directions = renderer::harmonics::fibonacci_directions(100, 8).directions;
    int leaks = 0;
    for (const auto& p : renderer::harmonics::fibonacci_directions(200, 4).directions)
        for (const auto& s : directions)
            if (std::abs(total(tracer.from_point(0.5 * p, s)) -
                         total(loose_tracer.from_point(0.5 * p, s))) > 1e-5)
                ++leaks;
    EXPECT_LE(leaks, 6);
}

// A flap hangs in the air beside a cube, as a triangle does to a ray that grazes an edge and meets
// one of its two sides: who knows to be outside sees past it, once the neighbour has missed it.
TEST(Crossings, OneTooManyIsFoundOutByWhoKnowsWhereTheRayStarts) {
    Mesh mesh = slab(2, 2, 2, 1);
    const auto n = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& corner : {glm::dvec3(0, 0, 0), glm::dvec3(0, 1e-5, 0), glm::dvec3(1e-5, 0, 0)})
        mesh.positions.push_back(glm::dvec3(-3e-6, -3e-6, 3) + corner);
    mesh.triangles.push_back({n + 1, n, n + 2}); // facing +z
    const RayScene scene(mesh);
    InteriorTracer tracer(scene);
    const glm::dvec3 start(0, 0, -20), up(0, 0, 1);
    EXPECT_EQ(tracer.from_point(start, up).front().begin, 0); // one crossing leaves: it was inside
    const auto known = tracer.from_point(start, up, Side::Outside);
    ASSERT_EQ(known.size(), 1u);
    EXPECT_NEAR(known[0].begin, 19, 1e-4);
    EXPECT_NEAR(known[0].end, 21, 1e-4);
    EXPECT_EQ(tracer.statistics().retried, 1u);
    EXPECT_LT(scene.triangles()[tracer.triangle_at(known[0].end)][0], n);
}

// The surface has the last word: two rays agree.
TEST(Crossings, OfAWrongBeliefAreWhatTheyAre) {
    const RayScene scene(sphere(1, 3));
    InteriorTracer tracer(scene);
    const glm::dvec3 s = glm::normalize(glm::dvec3(0.3, 0.2, 1));
    EXPECT_EQ(tracer.from_point({0, 0, 0}, s, Side::Outside).front().begin, 0);
    EXPECT_GT(tracer.from_point(-3.0 * s, s, Side::Inside).front().begin, 1.9);
    EXPECT_EQ(tracer.statistics().retried, 2u);
    EXPECT_EQ(tracer.statistics().fallbacks, 0u);
}

// Unconnected scales that all face the ray: no count of theirs adds up, and no two rays agree. They
// wind around nothing, and that decides.
TEST(Crossings, WhereNoTwoRaysAgreeTheWindingNumberDecides) {
    std::mt19937 random(5);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    Mesh mesh;
    mesh.positions = {{-1, 0, 0}, {1, 0, 0}}; // keeps the scene's size
    for (int i = 0; i < 400; ++i) {
        const glm::dvec3 p(4e-5 * uniform(), 4e-5 * uniform(), 0.1 * uniform());
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const auto& corner : {glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0)})
            mesh.positions.push_back(p + 2e-5 * corner);
        mesh.triangles.push_back({first, first + 1, first + 2}); // facing -z
    }
    const RayScene scene(mesh);
    InteriorTracer tracer(scene);
    EXPECT_TRUE(tracer.from_point({0, 0, -1}, {0, 0, 1}).empty());
    EXPECT_EQ(tracer.statistics().retried, 1u);
    EXPECT_EQ(tracer.statistics().fallbacks, 1u);
}

/// Lengths from every vertex in one direction, in bundles.
std::vector<double> in_bundles(InteriorTracer& tracer, std::size_t vertices, glm::dvec3 s) {
    std::vector<std::uint32_t> all(vertices);
    std::iota(all.begin(), all.end(), 0u);
    std::vector<double> lengths;
    tracer.from_vertices(all, s, [&](std::size_t i, std::span<const Segment> segments) {
        EXPECT_EQ(i, lengths.size());
        lengths.push_back(total(segments));
    });
    return lengths;
}

// 465 vertices: the last bundle is not full.  Rays along the axes meet edges and vertices
// everywhere, those of the ring meet one surface after the other.  Neighbours share the way, not
// the answer.
TEST(Crossings, InBundlesAreThoseOfSingleRaysToTheLastBit) {
    auto directions = renderer::harmonics::fibonacci_directions(40, 5).directions;
    directions.insert(directions.end(), axes.begin(), axes.end());
    for (const Mesh& mesh :
         {torus(1, 0.4, 31, 15), slab(2, 2, 2, 3), slab(2, 2, 2, 4), shell(1, 0.5, 2)}) {
        const RayScene scene(mesh);
        InteriorTracer single(scene), bundles(scene);
        for (const auto& s : directions) {
            const auto lengths = in_bundles(bundles, mesh.positions.size(), s);
            ASSERT_EQ(lengths.size(), mesh.positions.size());
            for (std::uint32_t v = 0; v < lengths.size(); ++v)
                EXPECT_EQ(lengths[v], total(single.from_vertex(v, s))) << v;
        }
        EXPECT_EQ(bundles.statistics().rays, single.statistics().rays);
        EXPECT_EQ(bundles.statistics().retried, single.statistics().retried);
        EXPECT_EQ(bundles.statistics().fallbacks, 0u);
    }
}

TEST(Crossings, FarFromTheOriginAreTheSame) {
    const Mesh near = torus(1, 0.4, 24, 12), far = moved(near, {1e6, -1e6, 1e6});
    const RayScene scene(near), far_scene(far);
    InteriorTracer tracer(scene), far_tracer(far_scene);
    for (const auto& s : renderer::harmonics::fibonacci_directions(20, 3).directions)
        for (std::uint32_t v = 0; v < near.positions.size(); v += 11)
            EXPECT_NEAR(total(tracer.from_vertex(v, s)), total(far_tracer.from_vertex(v, s)), 1e-5);
}

// What recentring in double saves: floats at 1e6 are 0.0625 apart, and rays between them miss.
TEST(Crossings, WithoutRecentringAFarMeshWouldBeLost) {
    EXPECT_EQ(static_cast<float>(1e6 + 0.03), static_cast<float>(1e6));
    const Mesh far = moved(sphere(1, 2), {1e6, 0, 0});
    const RayScene scene(far);
    double widest = 0;
    for (std::size_t v = 0; v < far.positions.size(); ++v)
        widest = std::max(widest, glm::distance(glm::dvec3(scene.positions()[v]),
                                                scene.scene_from_model(far.positions[v])));
    EXPECT_LE(widest, 1e-7); // half a float's spacing at 0.5, in each of three coordinates
}

TEST(CrossingsDeathTest, RefuseWhatIsNotThere) {
    const RayScene scene(sphere(1, 0));
    InteriorTracer tracer(scene);
    EXPECT_DEATH(tracer.from_vertex(12, {0, 0, 1}), "vertex");
    EXPECT_DEATH(tracer.from_vertex(0, {0, 0, 2}), "direction");
    EXPECT_DEATH(RayScene(Mesh{{{0, 0, 0}}, {}}), "radius");
}

} // namespace
