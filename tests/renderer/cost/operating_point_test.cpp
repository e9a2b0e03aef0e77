#include "renderer/cost/operating_point.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace renderer::cost;
using testing::ElementsAre;
using testing::IsEmpty;

Candidate steady(double frame, double error, std::size_t bytes = 0, double precompute = 0) {
    return {{frame, frame, frame}, error, bytes, precompute};
}

TEST(OperatingPoint, IsTheFastestThatIsGoodEnough) {
    const std::vector<Candidate> all{steady(1, 0.5), steady(3, 0.01), steady(2, 0.05),
                                     steady(1.5, 0.051)};
    const auto point = within_tolerance(all, 0.05);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->chosen, 2U); // the tolerance itself is good enough
    EXPECT_EQ(point->rule, Rule::GoodEnough);
    EXPECT_THAT(point->as_fast, IsEmpty());
}

// The fastest ran from 0.9 to 1.1; who has been as fast as 1.1 in a quarter of the rounds is as
// fast.
TEST(OperatingPoint, LetsMemoryDecideWhereTimesCannot) {
    const std::vector<Candidate> all{{{0.9, 1.0, 1.1}, 0.01, 100, 0},
                                     {{1.05, 1.2, 1.3}, 0.02, 16, 9},
                                     {{1.0, 1.1, 1.2}, 0.02, 16, 5},
                                     {{1.2, 1.3, 1.4}, 0.03, 4, 0}};
    const auto point = within_tolerance(all, 0.05);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->chosen, 2U); // of 16 bytes both, this takes less precomputation
    EXPECT_THAT(point->as_fast, ElementsAre(0U, 1U));
}

TEST(OperatingPoint, SaysWhenNothingIsGoodEnoughAndTakesTheBest) {
    const auto point = within_tolerance(std::vector{steady(1, 0.5), steady(2, 0.3)}, 0.1);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->chosen, 1U);
    EXPECT_EQ(point->rule, Rule::NothingIsGood);
}

TEST(OperatingPoint, IsTheBestThatIsFastEnough) {
    const std::vector<Candidate> all{steady(1, 0.5), steady(2, 0.3), steady(3, 0.1),
                                     steady(1.9, 0.3)};
    const auto point = within_budget(all, 2);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->chosen, 3U); // of equal errors the faster
    EXPECT_EQ(point->rule, Rule::FastEnough);
    const auto hurried = within_budget(all, 0.5);
    ASSERT_TRUE(hurried);
    EXPECT_EQ(hurried->chosen, 0U);
    EXPECT_EQ(hurried->rule, Rule::NothingIsFast);
}

TEST(OperatingPoint, NeverChoosesWhatIsNotKnown) {
    const double unknown = std::nan("");
    const std::vector<Candidate> all{steady(1, unknown), steady(2, 0.3)};
    EXPECT_EQ(within_tolerance(all, 0.5)->chosen, 1U);
    EXPECT_EQ(within_tolerance(all, 0.1)->chosen, 1U);
    EXPECT_EQ(within_budget(all, 5)->chosen, 1U);
    EXPECT_FALSE(within_tolerance(std::vector{steady(1, unknown)}, 1));
    EXPECT_FALSE(within_budget({}, 1));
}

} // namespace
