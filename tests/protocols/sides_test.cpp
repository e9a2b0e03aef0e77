#include "protocols/sides.h"

#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <map>

namespace {

using namespace protocols;

Rng rng(std::uint64_t number) {
    Seed seed{};
    for (auto byte = seed.rbegin(); number != 0; ++byte, number >>= 8)
        *byte = static_cast<std::uint8_t>(number & 0xff);
    return Rng(seed);
}

/// How often left minus how often right, by condition and by (scene, condition).
struct Imbalance {
    std::map<int, int> overall;
    std::map<std::pair<int, int>, int> by_scene;
};

Imbalance imbalance(const std::vector<Comparison>& comparisons, const std::vector<Side>& sides) {
    Imbalance sum;
    for (std::size_t i = 0; i < comparisons.size(); ++i) {
        const auto& [scene, first, second] = comparisons[i];
        const int sign = sides[i] == Side::Left ? 1 : -1;
        sum.overall[first] += sign;
        sum.overall[second] -= sign;
        sum.by_scene[{scene, first}] += sign;
        sum.by_scene[{scene, second}] -= sign;
    }
    return sum;
}

void expect_balance(const std::vector<Comparison>& comparisons, const std::vector<Side>& sides) {
    const auto [overall, by_scene] = imbalance(comparisons, sides);
    for (const auto& [condition, difference] : overall)
        RC_ASSERT(std::abs(difference) <= 1);
    for (const auto& [vertex, difference] : by_scene)
        RC_ASSERT(std::abs(difference) <= 1);
}

std::vector<Comparison> all_pairs(int scenes, int conditions, int pictures) {
    std::vector<Comparison> comparisons;
    for (int scene = 0; scene < scenes; ++scene)
        for (int picture = 0; picture < pictures; ++picture)
            for (int first = 0; first < conditions; ++first)
                for (int second = first + 1; second < conditions; ++second)
                    comparisons.push_back({scene, first, second});
    return comparisons;
}

RC_GTEST_PROP(DrawSides, LeavesNobodyOffByMoreThanOneInAnyDesign, (std::uint64_t seed)) {
    const auto comparisons = *rc::gen::container<std::vector<Comparison>>(rc::gen::map(
        rc::gen::tuple(rc::gen::inRange(0, 4), rc::gen::inRange(0, 6), rc::gen::inRange(1, 6)),
        [](const auto& drawn) {
            const auto [scene, first, step] = drawn;
            return Comparison{scene, first, (first + step) % 6};
        }));
    auto stream = rng(seed);
    const auto sides = draw_sides(comparisons, stream);
    RC_ASSERT(sides.size() == comparisons.size());
    expect_balance(comparisons, sides);
}

RC_GTEST_PROP(DrawSides, LeavesNobodyOffByMoreThanOneInCompleteDesigns, (std::uint64_t seed)) {
    const auto comparisons =
        all_pairs(*rc::gen::inRange(1, 5), *rc::gen::inRange(2, 9), *rc::gen::inRange(1, 5));
    auto stream = rng(seed);
    expect_balance(comparisons, draw_sides(comparisons, stream));
}

// Nine pictures of four conditions: each condition is in 9 trials of a scene and 27 in all, so it
// is left in 4 or 5 of a scene and in 13 or 14 overall.
TEST(DrawSides, SplitsTwentySevenIntoThirteenAndFourteen) {
    const auto comparisons = all_pairs(3, 4, 3);
    auto stream = rng(1);
    for (int i = 0; i < 100; ++i) {
        const auto sums = imbalance(comparisons, draw_sides(comparisons, stream));
        for (const auto& [condition, difference] : sums.overall)
            EXPECT_EQ(std::abs(difference), 1);
        for (const auto& [vertex, difference] : sums.by_scene)
            EXPECT_EQ(std::abs(difference), 1);
    }
}

// 4000 draws: 3.9 standard errors of 31.6 are 124, two-sided 1e-4 each, 0.005 over all 54.
TEST(DrawSides, PutEachPictureOnEitherSideHalfOfTheTime) {
    const auto comparisons = all_pairs(3, 4, 3);
    std::vector<int> left(comparisons.size());
    auto stream = rng(2);
    for (int draw = 0; draw < 4000; ++draw) {
        const auto sides = draw_sides(comparisons, stream);
        for (std::size_t i = 0; i < sides.size(); ++i)
            left[i] += sides[i] == Side::Left ? 1 : 0;
    }
    for (const auto count : left)
        EXPECT_NEAR(count, 2000, 124);
}

TEST(DrawSides, OfNothingAreNone) {
    auto stream = rng(3);
    EXPECT_TRUE(draw_sides({}, stream).empty());
}

TEST(DrawSidesDeathTest, AConditionAgainstItselfIsACallersBug) {
    auto stream = rng(4);
    const std::vector<Comparison> wrong{{0, 1, 1}};
    EXPECT_DEATH(draw_sides(wrong, stream), "first != second");
}

} // namespace
