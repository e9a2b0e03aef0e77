#include "analysis/anova/variance_components.h"
#include "protocols/random.h"

#include <cmath>

namespace {

using namespace analysis::anova;

// Two observers, two sessions, two levels.  Means of levels 6 and 2; observer 1 has 7 1, observer
// 2 has 5 3; sessions add +-1 to observer 1's difference.  By hand: MS_a = 32, MS_oa = 8,
// MS_e = 4/2.
TEST(VarianceComponents, OfASmallTableAreAsByHand) {
    const std::vector<std::int64_t> counts{8, 0, 6, 2, 5, 3, 5, 3};
    const auto result = variance_components(counts, 2, 2, 2, 1);
    EXPECT_DOUBLE_EQ(result.repetition, 2);
    EXPECT_DOUBLE_EQ(result.observer_x_condition, 3); // (8 - 2) / 2
    EXPECT_DOUBLE_EQ(result.condition, 6);            // (32 - 8) / 4
    EXPECT_DOUBLE_EQ(result.reliability, 6 / (6 + 1.5 + 0.5));
}

// Known components are found again: 400 observers, 3 sessions, 4 levels.  The sampling error of a
// component is about its mean square times sqrt(2 / df); five of those bound each, one chance in a
// million, with a fixed seed.
TEST(VarianceComponents, AreRecovered) {
    protocols::Rng rng({7});
    const auto normal = [&] {
        double sum = -6; // of twelve uniforms: variance 1
        for (int i = 0; i < 12; ++i)
            sum += protocols::draw_unit(rng);
        return sum;
    };
    std::vector<std::int64_t> counts;
    for (int o = 0; o < 400; ++o) {
        double taste[4];
        for (auto& t : taste)
            t = 200 * normal();
        for (int s = 0; s < 3; ++s)
            for (int a = 0; a < 4; ++a)
                counts.push_back(std::lround(1000 * a + taste[a] + 300 * normal()));
    }
    const auto result = variance_components(counts, 400, 3, 4, 100);
    EXPECT_NEAR(result.repetition, 9, 5 * 9 * std::sqrt(2.0 / (400 * 2 * 3)));
    EXPECT_NEAR(result.observer_x_condition, 4, 5 * 21 / 3.0 * std::sqrt(2.0 / (399 * 3)));
    // The variance of 0 10 20 30; a level's mean has error 0.13, which moves it by 2.
    EXPECT_NEAR(result.condition, 100 * 5.0 / 3, 10);
    EXPECT_GT(result.reliability, 0.999);
}

TEST(VarianceComponents, NeedSessions) {
    EXPECT_EQ(variance_components(std::vector<std::int64_t>{1, 2, 3, 4}, 2, 1, 2, 1).reason,
              "needs two observers, sessions and conditions");
}

} // namespace
