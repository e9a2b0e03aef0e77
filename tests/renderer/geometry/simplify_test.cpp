// Closed bodies stay closed, of as many pieces and handles, whatever is taken away.
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/mesh_report.h"
#include "renderer/geometry/simplify.h"

#include <algorithm>
#include <numbers>

namespace {

using namespace renderer::geometry;
using testing::HasSubstr;

bool same(const Mesh& a, const Mesh& b) {
    return a.positions == b.positions && a.triangles == b.triangles;
}

TEST(Simplify, KeepsBodiesClosedWithTheirPiecesCavitiesAndHandles) {
    for (const auto& mesh : {sphere(1, 4), shell(1, 0.6, 4), torus(1, 0.3, 64, 32),
                             rounded_box({1, 0.5, 0.25}, 0.1, 40)}) {
        const auto before = examine(mesh);
        auto simplifier = Simplifier::prepare(mesh);
        ASSERT_TRUE(simplifier) << simplifier.error();
        for (const std::size_t share : {2, 4, 8}) {
            const auto asked = mesh.triangles.size() / share;
            const auto fewer = simplifier->down_to(asked);
            ASSERT_TRUE(fewer) << fewer.error();
            EXPECT_LE(fewer->triangles.size(), asked);
            EXPECT_GE(fewer->triangles.size() + 2, asked);
            const auto after = examine(*fewer);
            EXPECT_TRUE(is_closed_and_oriented(after));
            EXPECT_EQ(after.boundary.count + after.non_manifold.count, 0U);
            EXPECT_EQ(after.unused_vertices, 0U);
            EXPECT_EQ(after.components, before.components);
            EXPECT_EQ(after.cavities, before.cavities);
            EXPECT_EQ(after.genus, before.genus);
        }
    }
}

// With h the length of an edge, a sphere through the vertices of a triangle lies h^2/(8 r) to
// h^2/(6 r) above it, which takes about that times the area from the volume.  640 triangles of 4 pi
// have edges of 0.21 where they are even: 3 * 0.21^2/6 = 2.2 %; twice that for uneven ones.
TEST(Simplify, MovesTheSurfaceLittle) {
    const auto fewer = simplify(sphere(1, 4), 640);
    ASSERT_TRUE(fewer) << fewer.error();
    const double exact = 4 * std::numbers::pi / 3;
    EXPECT_LE(std::abs(signed_volume(*fewer) / exact - 1), 0.044);
}

TEST(Simplify, KeepsVerticesWhereTheyWereEvenFarAway) {
    auto mesh = torus(1, 0.3, 32, 16);
    const auto here = simplify(mesh, 256);
    for (auto& p : mesh.positions)
        p = 1024.0 * p + glm::dvec3(1048576, 0, 0); // powers of two round little off
    const auto there = simplify(mesh, 256);
    ASSERT_TRUE(here && there);
    EXPECT_EQ(there->triangles.size(), here->triangles.size());
    for (const auto& p : there->positions)
        EXPECT_NE(std::ranges::find(mesh.positions, p), mesh.positions.end());
}

TEST(Simplify, GivesTheSameEveryTime) {
    const auto mesh = torus(1, 0.3, 48, 24);
    EXPECT_TRUE(same(*simplify(mesh, 500), *simplify(mesh, 500)));
}

TEST(Simplify, RefusesWhatIsNotClosed) {
    auto mesh = sphere(1, 2);
    mesh.triangles.pop_back();
    const auto open = simplify(mesh, 100);
    ASSERT_FALSE(open);
    EXPECT_THAT(open.error(), HasSubstr("only a closed manifold can be simplified"));
    EXPECT_THAT(open.error(), HasSubstr("3 boundary edges, the first from ("));
}

TEST(Simplify, RefusesSheetsThatTouch) {
    auto mesh = sphere(1, 2);
    const auto shift = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    const auto other = sphere(1, 2);
    // a second ball whose first vertex is the last of the first one
    for (std::size_t i = 1; i < other.positions.size(); ++i)
        mesh.positions.push_back(other.positions[i] + glm::dvec3(5, 0, 0));
    for (const auto& [a, b, c] : other.triangles)
        mesh.triangles.push_back({a + shift, b + shift, c + shift});
    const auto pinched = simplify(mesh, 100);
    ASSERT_FALSE(pinched);
    EXPECT_THAT(pinched.error(), HasSubstr("1 vertices where sheets touch"));
}

TEST(Simplify, RefusesAMeshThatFacesInward) {
    auto mesh = sphere(1, 2);
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[0], triangle[1]);
    EXPECT_THAT(simplify(mesh, 100).error(), HasSubstr("expected triangles that face outward"));
}

// A handle needs triangles: the fewest of a torus are 14.
TEST(Simplify, SaysWhenSoFewTrianglesCannotBe) {
    const auto fewer = simplify(torus(1, 0.3, 32, 16), 8);
    ASSERT_FALSE(fewer);
    EXPECT_THAT(fewer.error(), HasSubstr("are the fewest that keep its pieces and handles"));
}

} // namespace
