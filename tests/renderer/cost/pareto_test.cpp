#include "renderer/cost/pareto.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace renderer::cost;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(ParetoFront, KeepsWhatNothingBeatsByRisingCost) {
    //                                     0       1       2 dear   3       4 as bad
    const std::vector<Tradeoff> settings{{3, 1}, {1, 5}, {4, 2}, {2, 3}, {2.5, 3}};
    EXPECT_THAT(pareto_front(settings), ElementsAre(1U, 3U, 0U));
}

TEST(ParetoFront, HasOneOfEquals) {
    EXPECT_THAT(pareto_front(std::vector<Tradeoff>{{1, 1}, {1, 1}, {1, 2}}), ElementsAre(0U));
}

TEST(ParetoFront, KnowsNothingOfWhatIsNotKnown) {
    const double unknown = std::nan("");
    EXPECT_THAT(pareto_front(std::vector<Tradeoff>{{1, unknown}, {unknown, 0}, {2, 2}}),
                ElementsAre(2U));
    EXPECT_THAT(pareto_front({}), IsEmpty());
    EXPECT_THAT(pareto_front(std::vector<Tradeoff>{{1, unknown}}), IsEmpty());
}

// By the definition, all pairs, on 200 sets of up to 12 settings with many equals: nobody on the
// front is beaten, everybody else is.
TEST(ParetoFront, IsWhatItsDefinitionSays) {
    std::mt19937 random(7);
    for (int set = 0; set < 200; ++set) {
        std::vector<Tradeoff> settings(random() % 12);
        for (auto& setting : settings)
            setting = {static_cast<double>(random() % 6), static_cast<double>(random() % 6)};
        const auto front = pareto_front(settings);
        for (const auto& mine : settings) {
            const bool beaten =
                std::any_of(settings.begin(), settings.end(), [&](const auto& other) {
                    return (other.cost < mine.cost && other.error <= mine.error) ||
                           (other.cost <= mine.cost && other.error < mine.error);
                });
            const bool is_there = std::any_of(front.begin(), front.end(), [&](auto k) {
                return settings[k].cost == mine.cost && settings[k].error == mine.error;
            });
            EXPECT_NE(is_there, beaten) << set;
        }
    }
}

} // namespace
