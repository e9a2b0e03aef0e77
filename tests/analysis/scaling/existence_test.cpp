#include "analysis/scaling/existence.h"

#include <rapidcheck/gtest.h>

namespace {

using namespace analysis::scaling;
using Components = std::vector<std::vector<std::size_t>>;

Existence of(std::size_t t, const std::vector<std::int64_t>& wins) {
    return existence({t, wins});
}

TEST(Existence, IsFiniteAroundACircle) {
    const auto found = of(3, {0, 1, 0, 0, 0, 1, 1, 0, 0});
    EXPECT_EQ(found.scale, Scale::Finite);
    EXPECT_EQ(found.components, (Components{{0, 1, 2}}));
}

TEST(Existence, NamesTheComponentsFromTheTop) {
    // 2 beats 0 beats 3 beats 1, nothing back but 0 and 3 between themselves.
    const auto found = of(4, {0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0});
    EXPECT_EQ(found.scale, Scale::Separated);
    EXPECT_EQ(found.components, (Components{{2}, {0, 3}, {1}}));
}

TEST(Existence, SaysWhoWasNeverComparedWithWhom) {
    const auto found = of(4, {0, 0, 5, 0, 0, 0, 0, 1, 2, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(found.scale, Scale::Disconnected);
    EXPECT_EQ(found.components, (Components{{0, 2}, {1, 3}}));
}

TEST(Existence, WithoutVotesEveryConditionIsAlone) {
    EXPECT_EQ(of(2, {0, 0, 0, 0}).scale, Scale::Disconnected);
    EXPECT_EQ(of(1, {0}).scale, Scale::Finite);
}

// Oracle: Warshall's closure.
RC_GTEST_PROP(Existence, AgreesWithTransitiveClosure, ()) {
    const auto t = *rc::gen::inRange<std::size_t>(1, 8);
    auto wins = *rc::gen::container<std::vector<std::int64_t>>(
        t * t, rc::gen::weightedElement<std::int64_t>({{3, 0}, {1, 1}}));
    std::vector<bool> reach(t * t);
    for (std::size_t i = 0; i < t; ++i) {
        wins[i * t + i] = 0;
        for (std::size_t j = 0; j < t; ++j)
            reach[i * t + j] = i == j || wins[i * t + j] > 0;
    }
    for (std::size_t k = 0; k < t; ++k)
        for (std::size_t i = 0; i < t; ++i)
            for (std::size_t j = 0; j < t; ++j)
                reach[i * t + j] = reach[i * t + j] || (reach[i * t + k] && reach[k * t + j]);
    bool strong = true;
    for (std::size_t at = 0; at < t * t; ++at)
        strong = strong && reach[at];
    const auto found = of(t, wins);
    RC_ASSERT((found.scale == Scale::Finite) == strong);
    if (found.scale == Scale::Separated) // nobody is beaten from below
        for (std::size_t above = 0; above < found.components.size(); ++above)
            for (std::size_t below = above + 1; below < found.components.size(); ++below)
                for (const auto i : found.components[below])
                    for (const auto j : found.components[above])
                        RC_ASSERT(wins[i * t + j] == 0);
}

} // namespace
