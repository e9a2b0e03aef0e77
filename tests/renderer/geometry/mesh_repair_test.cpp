// What is mended, what is left, and what is said about either.
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/mesh_repair.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace {

using namespace renderer::geometry;
using testing::ElementsAre;
using testing::HasSubstr;

/// Every triangle with vertices of its own, as some files have them.
Mesh shattered(const Mesh& mesh) {
    Mesh result;
    for (const auto& triangle : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(result.positions.size());
        for (const auto corner : triangle)
            result.positions.push_back(mesh.positions[corner]);
        result.triangles.push_back({first, first + 1, first + 2});
    }
    return result;
}

std::string error_of(const Mesh& mesh) {
    const auto prepared = prepare(mesh, "a.off");
    return prepared ? "no error" : prepared.error();
}

TEST(MeshRepair, LeavesAGoodMeshAlone) {
    const auto mesh = torus(1, 0.3, 16, 8);
    const auto prepared = prepare(mesh, "torus");
    ASSERT_TRUE(prepared) << prepared.error();
    EXPECT_EQ(prepared->mesh.positions, mesh.positions);
    EXPECT_EQ(prepared->mesh.triangles, mesh.triangles);
    EXPECT_TRUE(describe(prepared->repairs).empty());
}

TEST(MeshRepair, WeldsRepeatedVertices) {
    const auto whole = sphere(1, 2);
    const auto prepared = prepare(shattered(whole), "sphere");
    ASSERT_TRUE(prepared) << prepared.error();
    EXPECT_EQ(prepared->mesh.positions.size(), whole.positions.size());
    EXPECT_EQ(prepared->report.genus, 0);
    EXPECT_EQ(prepared->repairs.welded_vertices,
              3 * whole.triangles.size() - whole.positions.size());
    EXPECT_EQ(prepared->repairs.unused_vertices,
              0u); // what welding leaves over is no second repair
}

TEST(MeshRepair, TakesMinusZeroForZero) {
    auto mesh = shattered(slab(1, 1, 1, 2));
    for (std::size_t v = 0; v < mesh.positions.size(); v += 2)
        for (int axis = 0; axis < 3; ++axis)
            if (mesh.positions[v][axis] == 0)
                mesh.positions[v][axis] = -0.0;
    EXPECT_TRUE(prepare(mesh, "slab"));
}

TEST(MeshRepair, WeldsNearVerticesOnlyWhenAsked) {
    auto mesh = shattered(sphere(1, 2));
    double sign = 1;
    for (auto& p : mesh.positions)
        p += (sign = -sign) * glm::dvec3(3e-8, -2e-8, 1e-8); // pairs differ by at most 7.5e-8
    EXPECT_THAT(error_of(mesh), HasSubstr("boundary edges"));
    const auto prepared = prepare(mesh, "sphere", {.weld_within = 1e-7}); // of the diameter, 2
    ASSERT_TRUE(prepared) << prepared.error();
    EXPECT_EQ(prepared->mesh.positions.size(), sphere(1, 2).positions.size());
}

TEST(MeshRepair, TurnsAMeshThatFacesInward) {
    auto mesh = shell(1, 0.5, 2); // the cavity is turned with the rest, and is a cavity still
    const double volume = examine(mesh).volume;
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[0], triangle[2]);
    const auto prepared = prepare(mesh, "shell");
    ASSERT_TRUE(prepared) << prepared.error();
    EXPECT_TRUE(prepared->repairs.is_flipped);
    EXPECT_DOUBLE_EQ(prepared->report.volume, volume);
    EXPECT_EQ(prepared->report.cavities, 1u);
    EXPECT_THAT(describe(prepared->repairs),
                ElementsAre("the surface faced inward (negative volume) and was turned outward"));
}

TEST(MeshRepair, DropsWhatCountsForNothing) {
    auto mesh = slab(1, 1, 1, 2);
    const auto good = mesh;
    mesh.positions.insert(mesh.positions.begin(), {7, 7, 7}); // in no triangle
    for (auto& triangle : mesh.triangles)
        for (auto& corner : triangle)
            ++corner;
    mesh.triangles.push_back(mesh.triangles[5]); // repeated
    mesh.triangles.push_back({1, 2, 1});         // collapsed
    const auto prepared = prepare(mesh, "slab");
    ASSERT_TRUE(prepared) << prepared.error();
    EXPECT_EQ(prepared->mesh.positions, good.positions);
    EXPECT_EQ(prepared->mesh.triangles, good.triangles);
    EXPECT_THAT(describe(prepared->repairs),
                ElementsAre("collapsed triangles: 1 dropped", "repeated triangles: 1 dropped",
                            "vertices in no triangle: 1 dropped"));
}

/// A tetrahedron one of whose edges, 0 to 1, has the vertex 4 in its middle on one side only; a
/// needle 0 4 1 closes the gap of no width.
Mesh tetrahedron_with_needle() {
    return {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}},
            {{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 1, 4}}};
}

TEST(MeshRepair, KeepsANeedleThatHoldsTheSurfaceTogether) {
    const auto prepared = prepare(tetrahedron_with_needle(), "tetrahedron");
    ASSERT_TRUE(prepared) << prepared.error();
    EXPECT_EQ(prepared->repairs.needles_kept, 1u);
    EXPECT_EQ(prepared->mesh.triangles.size(), 6u);
    EXPECT_NEAR(prepared->report.volume, 8.0 / 6, 1e-15);
}

TEST(MeshRepair, DropsANeedleThatHangsOn) {
    auto mesh = slab(1, 1, 1, 1);
    mesh.positions.emplace_back(-0.5, -0.5, 0);
    mesh.positions.emplace_back(-0.5, -0.5, 0.25);
    mesh.triangles.push_back({0, 8, 9});
    const auto prepared = prepare(mesh, "slab");
    ASSERT_TRUE(prepared) << prepared.error();
    EXPECT_EQ(prepared->repairs.needle_triangles, 1u);
    EXPECT_EQ(prepared->mesh.positions.size(), 8u);
}

TEST(Prepare, SaysWhyAMeshHasNoInside) {
    auto open = slab(2, 2, 2, 1);
    open.triangles.pop_back();
    EXPECT_EQ(
        error_of(open),
        "a.off: the surface is not closed and consistently oriented, so it has no inside to "
        "measure: 3 boundary edges, the first from (-1, 1, 1) to (-1, -1, 1); mend it in a mesh "
        "editor, take what it winds around for its inside (holes = \"winding\" in its "
        "[[scene]], or --holes winding, where a command takes that), or choose a closed model");
    auto turned = slab(2, 2, 2, 1);
    std::swap(turned.triangles[0][0], turned.triangles[0][1]);
    EXPECT_THAT(error_of(turned), HasSubstr("3 edges whose two triangles face opposite ways"));
    auto finned = slab(2, 2, 2, 1);
    finned.positions.emplace_back(5, 5, 5);
    finned.triangles.push_back({0, 1, 8});
    EXPECT_THAT(error_of(finned), HasSubstr("1 edge with more than two triangles, the first from"));
}

TEST(Prepare, RefusesWhatEnclosesNothing) {
    EXPECT_THAT(error_of({}), HasSubstr("a.off: no triangle has an area"));
    EXPECT_THAT(error_of({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}}}),
                HasSubstr("no triangle has an area"));
    const Mesh two_sides{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
    EXPECT_THAT(error_of(two_sides),
                HasSubstr("a sheet without an inside: it encloses a volume of 0, expected more"));
}

std::string error_with_openings(const Mesh& mesh) {
    const auto prepared = prepare(mesh, "a.off", {.holes = Holes::ByWinding});
    return prepared ? "no error" : prepared.error();
}

// Rounding gives some tilted sheets a volume above 0: that is no inside either.
TEST(Prepare, RefusesOpenSheetsHoweverTheyLie) {
    for (int lie = 0; lie < 40; ++lie) {
        const double turn = 0.1 * lie;
        const glm::dvec3 x(std::cos(turn), std::sin(turn), 0),
            y(-std::sin(turn) * std::cos(lie), std::cos(turn) * std::cos(lie), std::sin(lie));
        Mesh sheet;
        constexpr std::uint32_t n = 6;
        for (std::uint32_t i = 0; i <= n; ++i)
            for (std::uint32_t j = 0; j <= n; ++j) // as a file of single precision has them
                sheet.positions.emplace_back(glm::vec3(0.1 * i * x + 0.1 * j * y));
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = 0; j < n; ++j) {
                const auto a = i * (n + 1) + j, b = a + n + 1;
                sheet.triangles.push_back({a, b, a + 1});
                sheet.triangles.push_back({b, b + 1, a + 1});
            }
        EXPECT_THAT(error_with_openings(sheet),
                    testing::AllOf(HasSubstr("a.off: the surface is a sheet without an inside"),
                                   HasSubstr("give it a thickness in a mesh editor")))
            << lie;
    }
    const std::vector<glm::dvec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                          {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    for (const Triangle& upper : {Triangle{3, 4, 5}, Triangle{3, 5, 4}})
        EXPECT_THAT(error_with_openings({corners, {{0, 1, 2}, upper}}), HasSubstr("a sheet"));
}

TEST(Prepare, SaysHowAnOpenBodyThatFacesInwardIsMended) {
    auto cup = slab(1, 1, 1, 1);
    cup.triangles.pop_back();
    cup.triangles.pop_back();
    EXPECT_EQ(error_with_openings(cup), "no error");
    for (auto& triangle : cup.triangles)
        std::swap(triangle[1], triangle[2]);
    EXPECT_EQ(error_with_openings(cup),
              "a.off: the surface faces inward: it encloses a volume of -1, expected more than 0; "
              "turn its triangles in a mesh editor (flip the normals), counter-clockwise seen from "
              "outside");
    // A hair is thin, but has an inside.
    EXPECT_EQ(error_with_openings(slab(1e-4, 1e-4, 1, 1)), "no error");
}

} // namespace
