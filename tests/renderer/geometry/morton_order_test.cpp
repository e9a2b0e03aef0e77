#include "renderer/geometry/bodies.h"
#include "renderer/geometry/morton_order.h"

#include <algorithm>
#include <random>

namespace {

using namespace renderer::geometry;

TEST(MortonOrder, WalksTheEightOctantsInTheirOrder) {
    const std::vector<glm::vec3> corners{{.4f, .4f, .4f},   {-.4f, .4f, .4f},  {.4f, -.4f, .4f},
                                         {-.4f, -.4f, .4f}, {.4f, .4f, -.4f},  {-.4f, .4f, -.4f},
                                         {.4f, -.4f, -.4f}, {-.4f, -.4f, -.4f}};
    EXPECT_EQ(morton_order(corners), (std::vector<std::uint32_t>{7, 6, 5, 4, 3, 2, 1, 0}));
}

TEST(MortonOrder, NamesEveryPointOnceWhereverItLies) {
    const std::vector<glm::vec3> points{{0, 0, 0}, {0, 0, 0}, {7, 0, 0}, {-7, -7, -7}};
    auto order = morton_order(points);
    EXPECT_EQ(order.front(), 3u);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(AlongMortonCurve, IsTheSameSurfaceInAnotherOrder) {
    const auto body = torus(1, 0.4, 48, 24);
    const auto moved = along_morton_curve(body);
    ASSERT_EQ(moved.positions.size(), body.positions.size());
    ASSERT_EQ(moved.triangles.size(), body.triangles.size());
    EXPECT_NE(moved.positions, body.positions);
    for (std::size_t i = 0; i < body.triangles.size(); ++i)
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_EQ(moved.positions[moved.triangles[i][j]], body.positions[body.triangles[i][j]]);
}

// 18 patches of 64 vertices against 64 vertices from anywhere, whose spheres are the whole torus's.
// Blocks in which the curve leaps are no patches: 0.62 on average.
TEST(AlongMortonCurve, KeepsBlocksOfVerticesTogether) {
    const auto mean_radius = [](const Mesh& mesh) {
        double sum = 0;
        int blocks = 0;
        for (std::size_t begin = 0; begin + 64 <= mesh.positions.size(); begin += 64, ++blocks) {
            const auto first = mesh.positions.begin() + static_cast<std::ptrdiff_t>(begin);
            sum += bounding_sphere({{first, first + 64}, {}}).radius;
        }
        return sum / blocks;
    };
    std::mt19937 random(3);
    auto shuffled = torus(1, 0.4, 48, 24);
    std::shuffle(shuffled.positions.begin(), shuffled.positions.end(), random);
    EXPECT_LE(mean_radius(along_morton_curve(shuffled)), 0.7 * mean_radius(shuffled));
}

} // namespace
