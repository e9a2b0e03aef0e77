#include "renderer/thickness/band_fade.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using renderer::thickness::BandFade;

std::vector<double> weights_of(const BandFade& fade) {
    return {fade.weights().begin(), fade.weights().end()};
}

TEST(BandFade, StartsAtRest) {
    const BandFade fade(5, 2);
    EXPECT_EQ(weights_of(fade), (std::vector<double>{1, 1, 0, 0, 0}));
    EXPECT_EQ(fade.bands(), 2);
}

TEST(BandFade, TakesAHundredAndFiftyMilliseconds) {
    BandFade fade(5, 2);
    fade.advance(5, 0.075);
    EXPECT_EQ(fade.weights()[1], 1);
    for (std::size_t l = 2; l < 5; ++l)
        EXPECT_NEAR(fade.weights()[l], 0.5, 1e-12);
    EXPECT_EQ(fade.bands(), 5);
    fade.advance(5, 0.0751);
    EXPECT_EQ(weights_of(fade), (std::vector<double>{1, 1, 1, 1, 1}));
    fade.advance(2, 0.149);
    EXPECT_EQ(fade.bands(), 5);
    fade.advance(2, 0.0011);
    EXPECT_EQ(weights_of(fade), (std::vector<double>{1, 1, 0, 0, 0}));
}

// Whatever is wanted from frame to frame, no weight ever moves faster than its ramp, and lower
// bands never have less than higher ones.
TEST(BandFade, NeverJumps) {
    std::mt19937 random(11);
    BandFade fade(5, 3);
    for (int frame = 0; frame < 10000; ++frame) {
        const auto before = weights_of(fade);
        const double seconds = static_cast<double>(random() % 40) / 1000;
        fade.advance(1 + static_cast<int>(random() % 5), seconds);
        for (std::size_t l = 0; l < 5; ++l) {
            EXPECT_LE(std::abs(fade.weights()[l] - before[l]), seconds / 0.150 + 1e-12);
            EXPECT_GE(fade.weights()[l], 0);
            EXPECT_LE(fade.weights()[l], 1);
        }
        EXPECT_TRUE(std::is_sorted(fade.weights().rbegin(), fade.weights().rend()));
        EXPECT_EQ(fade.weights()[0], 1);
    }
}

TEST(BandFade, TurnsBackFromWhereItIs) {
    BandFade fade(5, 2);
    fade.advance(5, 0.060);
    fade.advance(2, 0.030);
    EXPECT_NEAR(fade.weights()[3], 0.2, 1e-12);
    fade.advance(2, 0);
    EXPECT_NEAR(fade.weights()[3], 0.2, 1e-12);
}

TEST(BandFadeDeathTest, RefusesBandsAndTimesThatCannotBe) {
    BandFade fade(5, 2);
    EXPECT_DEATH(fade.advance(6, 0.01), "wanted");
    EXPECT_DEATH(fade.advance(0, 0.01), "wanted");
    EXPECT_DEATH(fade.advance(2, -0.01), "seconds");
    EXPECT_DEATH(fade.advance(2, std::nan("")), "seconds");
    EXPECT_DEATH(BandFade(3, 4), "bands");
}

} // namespace
