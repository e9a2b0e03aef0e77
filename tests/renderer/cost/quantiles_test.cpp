#include "renderer/cost/quantiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace renderer::cost;
using testing::ElementsAre;

TEST(Quantiles, LieBetweenNeighbours) {
    EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
    EXPECT_EQ(quantile({1, 2}, 0.25), 1.25);
    EXPECT_EQ(quantile({7}, 0.9), 7);
    EXPECT_EQ(spread_of({5, 1, 2, 4, 3}), (Spread{2, 3, 4}));
}

TEST(Quantiles, RatiosAreOfTheRoundsThatBothHave) {
    EXPECT_THAT(ratios(std::vector{2.0, 6.0}, std::vector{1.0, 3.0, 9.0}), ElementsAre(2, 2));
}

} // namespace
