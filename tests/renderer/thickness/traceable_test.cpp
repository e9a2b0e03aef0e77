#include "renderer/geometry/bodies.h"
#include "renderer/thickness/thickness_field.h"
#include "renderer/thickness/traceable.h"
#include "tests/renderer/geometry/assembly.h"

#include <glm/geometric.hpp>

#include <limits>

namespace {

using namespace renderer::thickness;
using namespace renderer::geometry;
using testing::HasSubstr;

std::string complaint(const Mesh& mesh) {
    const auto field = compute_thickness_field(mesh, {.bands = 1, .directions = 16});
    const std::vector<glm::dvec3> sideways{glm::normalize(glm::dvec3(1, 0.01, 0.02))};
    const auto traced = trace_thickness(mesh, Kind::Sum, sideways);
    EXPECT_EQ(field.has_value(), traced.has_value());
    if (field || traced)
        return "";
    EXPECT_EQ(field.error().substr(0, 9), traced.error().substr(0, 9));
    return field.error();
}

TEST(Traceable, AreClosedBodiesWithCavitiesAndNeighbours) {
    EXPECT_EQ(complaint(sphere(1, 2)), "");
    EXPECT_EQ(complaint(shell(1, 0.5, 2)), "");
    EXPECT_EQ(complaint(torus(1, 0.4, 12, 8)), "");
    EXPECT_EQ(complaint(together(sphere(1, 2), sphere(1, 2), {1, 0, 0})), "");
}

TEST(Traceable, AnOpeningMayBeThereAsLongAsSomethingIsEnclosed) {
    Mesh open = sphere(1, 2);
    open.triangles.erase(open.triangles.begin());
    EXPECT_EQ(complaint(open), "");
    EXPECT_THAT(complaint({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}),
                HasSubstr("encloses a volume of 0,"));
}

TEST(Traceable, ATurnedTriangleIsNotConsistent) {
    Mesh turned = sphere(1, 2);
    std::swap(turned.triangles[5][0], turned.triangles[5][1]);
    EXPECT_THAT(complaint(turned),
                HasSubstr("not consistently oriented: 3 edges whose two triangles face"));
}

TEST(Traceable, ABodyInsideOutHasANegativeVolume) {
    EXPECT_THAT(complaint(flipped(slab(1, 2, 3, 1))), HasSubstr("encloses a volume of -6,"));
}

TEST(Traceable, APartInsideOutIsNamed) {
    const Mesh mesh = together(sphere(2, 2), flipped(sphere(1, 1)), {5, 0, 0});
    EXPECT_THAT(complaint(mesh), HasSubstr("component of vertex 162 faces inward"));
}

TEST(Traceable, NothingAndNotANumberAreRefused) {
    EXPECT_THAT(complaint({}), HasSubstr("no triangles"));
    Mesh lost = sphere(1, 0);
    lost.positions[3].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(complaint(lost), HasSubstr("vertex 3 is at ("));
}

// Two triangles back to back: whichever way a ray goes through, entry and exit are one.
TEST(Traceable, ASheetWithoutThicknessLeavesRaysUnresolved) {
    Mesh sheet;
    sheet.positions = {{3, -3, -3}, {3, 3, -3}, {3, 0, 3}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
    EXPECT_THAT(complaint(together(sphere(1, 2), sheet, {0, 0, 0})),
                HasSubstr("could not be resolved"));
}

TEST(Traceable, TooFewDirectionsAreRefused) {
    const auto field = compute_thickness_field(sphere(1, 1), {.bands = 5, .directions = 49});
    ASSERT_FALSE(field);
    EXPECT_EQ(field.error(), "49 directions cannot carry 25 coefficients, expected 50 or more");
}

} // namespace
