#include "renderer/geometry/morton_order.h"

#include <algorithm>

namespace {

using renderer::geometry::morton_order;

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

} // namespace
