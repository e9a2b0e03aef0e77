#include "renderer/geometry/bodies.h"
#include "renderer/smoothing/cotangent_laplacian.h"

#include <numeric>

namespace {

using namespace renderer;
using smoothing::cotangent_laplacian;

// Two right triangles of a unit square: across the diagonal lie two right angles (cot 0), across
// each side one of 45 degrees (cot 1).
TEST(CotangentLaplacian, OfASquareHasItsCotangents) {
    const geometry::Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                {{0, 1, 2}, {0, 2, 3}}};
    const auto laplacian = cotangent_laplacian(square);
    ASSERT_EQ(laplacian.edges.size(), 5u);
    for (const auto& [ends, weight] : laplacian.edges) {
        const bool is_diagonal = ends[0] == 0 && ends[1] == 2;
        EXPECT_NEAR(weight, is_diagonal ? 0 : 0.5, 1e-15);
    }
    EXPECT_THAT(laplacian.areas,
                testing::ElementsAre(testing::DoubleEq(1.0 / 3), testing::DoubleEq(1.0 / 6),
                                     testing::DoubleEq(1.0 / 3), testing::DoubleEq(1.0 / 6)));
    EXPECT_EQ(laplacian.clamped, 0u);
}

TEST(CotangentLaplacian, SharesOutTheWholeArea) {
    const auto areas = cotangent_laplacian(geometry::slab(2, 3, 0.5, 5)).areas;
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 2 * (2 * 3 + 2 * 0.5 + 3 * 0.5),
                1e-12);
}

// A flat kite: across its long diagonal lie two angles of about 157 degrees.
TEST(CotangentLaplacian, HasNoNegativeWeights) {
    const geometry::Mesh kite{{{-1, 0, 0}, {0, -0.2, 0}, {1, 0, 0}, {0, 0.2, 0}},
                              {{0, 1, 2}, {0, 2, 3}}};
    const auto laplacian = cotangent_laplacian(kite);
    EXPECT_EQ(laplacian.clamped, 1u);
    for (const auto& [ends, weight] : laplacian.edges)
        EXPECT_GE(weight, 0);
}

TEST(CotangentLaplacian, PassesOverTrianglesWithoutArea) {
    const geometry::Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}},
                              {{0, 1, 2}, {0, 1, 3}, {1, 1, 3}}};
    const auto laplacian = cotangent_laplacian(mesh);
    EXPECT_EQ(laplacian.edges.size(), 3u);
    EXPECT_EQ(laplacian.areas[2], 0);
}

} // namespace
