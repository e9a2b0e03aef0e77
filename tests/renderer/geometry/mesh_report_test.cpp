// What is said about meshes whose faults are known.
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/mesh_report.h"

#include <cmath>
#include <numbers>

namespace {

using namespace renderer::geometry;
using testing::Contains;
using testing::HasSubstr;

/// Both meshes in one, the second moved.
Mesh together(Mesh one, const Mesh& other, glm::dvec3 offset) {
    const auto shift = static_cast<std::uint32_t>(one.positions.size());
    for (const auto& p : other.positions)
        one.positions.push_back(p + offset);
    for (const auto& [a, b, c] : other.triangles)
        one.triangles.push_back({a + shift, b + shift, c + shift});
    return one;
}

TEST(MeshReport, KnowsTheGenusOfBodies) {
    EXPECT_EQ(examine(sphere(1, 2)).genus, 0);
    EXPECT_EQ(examine(torus(1, 0.3, 12, 8)).genus, 1);
    EXPECT_EQ(examine(together(torus(1, 0.3, 12, 8), torus(1, 0.3, 12, 8), {5, 0, 0})).genus, 2);
    EXPECT_EQ(examine(slab(1, 1, 0.1, 4)).genus, 0);
}

TEST(MeshReport, MeasuresABox) {
    const auto report = examine(slab(2, 3, 4, 2));
    EXPECT_NEAR(report.volume, 24, 1e-12);
    EXPECT_NEAR(report.area, 2 * (6 + 8 + 12), 1e-12);
    EXPECT_EQ(report.low, glm::dvec3(-1, -1.5, -2));
    EXPECT_EQ(report.high, glm::dvec3(1, 1.5, 2));
    EXPECT_TRUE(is_closed_and_oriented(report));
}

TEST(MeshReport, CountsComponentsAndCavities) {
    const auto report = examine(together(shell(1, 0.5, 2), sphere(1, 2), {5, 0, 0}));
    EXPECT_EQ(report.components, 3u);
    EXPECT_EQ(report.cavities, 1u);
    EXPECT_EQ(report.genus, 0);
    EXPECT_TRUE(is_closed_and_oriented(report));
}

TEST(MeshReport, FindsAHole) {
    auto mesh = slab(2, 2, 2, 1);
    mesh.triangles.pop_back();
    const auto report = examine(mesh);
    EXPECT_EQ(report.boundary.count, 3u);
    EXPECT_EQ(report.unbalanced.count, 3u);
    EXPECT_FALSE(is_closed_and_oriented(report));
    EXPECT_FALSE(report.genus);
    EXPECT_THAT(describe_openings(report), HasSubstr("3 boundary edges, the first from ("));
}

TEST(MeshReport, FindsATurnedTriangle) {
    auto mesh = slab(2, 2, 2, 1);
    std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
    const auto report = examine(mesh);
    EXPECT_EQ(report.boundary.count, 0u);
    EXPECT_EQ(report.inconsistent.count, 3u);
    EXPECT_FALSE(is_closed_and_oriented(report));
    EXPECT_THAT(describe(report), Contains(HasSubstr("3 edges whose two triangles face opposite")));
}

TEST(MeshReport, TellsCubesThatShareAnEdgeFromOnesThatShareACorner) {
    // Indices are shared by hand: the second cube's nearest edge or corner is the first one's.
    auto share = [](Mesh mesh, std::size_t first_of_second) {
        for (std::size_t v = first_of_second; v < mesh.positions.size(); ++v)
            for (std::uint32_t u = 0; u < first_of_second; ++u)
                if (mesh.positions[u] == mesh.positions[v])
                    for (auto& t : mesh.triangles)
                        std::replace(t.begin(), t.end(), static_cast<std::uint32_t>(v), u);
        return mesh;
    };
    const auto cube = slab(1, 1, 1, 1);
    const auto edge = examine(share(together(cube, cube, {1, 1, 0}), 8));
    EXPECT_EQ(edge.non_manifold.count, 1u);
    EXPECT_EQ(edge.unused_vertices, 2u);
    EXPECT_TRUE(is_closed_and_oriented(edge)); // a ray through either cube goes in and out
    EXPECT_FALSE(edge.genus);
    const auto corner = examine(share(together(cube, cube, {1, 1, 1}), 8));
    EXPECT_EQ(corner.non_manifold.count, 0u);
    EXPECT_EQ(corner.pinched_vertices, 1u);
    EXPECT_EQ(corner.components, 1u);
    EXPECT_TRUE(is_closed_and_oriented(corner));
    EXPECT_FALSE(corner.genus);
}

TEST(MeshReport, CountsWhatShouldNotBeThere) {
    auto mesh = slab(1, 1, 1, 1);
    auto repeated = mesh.triangles[3];
    std::rotate(repeated.begin(), repeated.begin() + 1, repeated.end());
    mesh.triangles.push_back(repeated);
    mesh.positions.emplace_back(9, 9, 9);
    mesh.triangles.push_back({0, 0, 1});
    const auto report = examine(mesh);
    EXPECT_EQ(report.duplicate, 1u);
    EXPECT_EQ(report.unused_vertices, 1u);
    EXPECT_EQ(report.zero_area, 1u);
    EXPECT_THAT(describe(report),
                testing::IsSupersetOf({"1 triangle repeats another", "1 vertex in no triangle",
                                       "1 triangle without area"}));
}

TEST(MeshReport, OfNothingIsNotClosed) {
    const auto report = examine({});
    EXPECT_FALSE(is_closed_and_oriented(report));
    EXPECT_EQ(report.components, 0u);
}

TEST(MeshReport, ReadsWell) {
    EXPECT_THAT(describe(examine(slab(2, 2, 2, 1))),
                testing::ElementsAre("8 vertices, 12 triangles",
                                     "1 component; closed and consistently oriented, genus 0",
                                     "size 2 x 2 x 2, area 24, volume 8 (model units)"));
    EXPECT_EQ(describe(examine(shell(1, 0.5, 1)))[1],
              "2 components, 1 of them facing inward; closed and consistently oriented, genus 0");
}

TEST(HasArea, DoesNotDependOnTheUnit) {
    for (const double unit : {1e-6, 1.0, 1e6}) {
        const Mesh mesh{{{0, 0, 0}, {unit, 0, 0}, {0.5 * unit, 1e-9 * unit, 0}, {2 * unit, 0, 0}},
                        {}};
        EXPECT_TRUE(has_area(mesh, {0, 1, 2}));
        EXPECT_FALSE(has_area(mesh, {0, 1, 3}));
        EXPECT_FALSE(has_area(mesh, {0, 1, 1}));
    }
}

} // namespace
