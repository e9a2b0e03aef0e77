#include "renderer/imaging/colour.h"

#include <cmath>
#include <limits>

namespace {

using namespace renderer;
using namespace renderer::imaging;

TEST(SrgbCurve, MiddleGreyCodeIsTwentyTwoPercentOfWhite) {
    EXPECT_NEAR(linear_from_srgb(128 / 255.0), 0.2158605, 5e-8); // printed to seven digits
    EXPECT_EQ(code_8bit(srgb_from_linear(0.5)), 188);            // half the light is code 188
}

TEST(SrgbCurve, EndsAtBlackAndWhite) {
    EXPECT_EQ(srgb_from_linear(0), 0);
    EXPECT_NEAR(srgb_from_linear(1), 1, 1e-15); // (1 + a) 1 - a, one rounding
    EXPECT_EQ(linear_from_srgb(0), 0);
    EXPECT_EQ(linear_from_srgb(1), 1);
}

TEST(SrgbCurve, ClipsLightBeyondWhiteAndBelowBlack) {
    EXPECT_EQ(srgb_from_linear(7), srgb_from_linear(1));
    EXPECT_EQ(srgb_from_linear(std::numeric_limits<double>::infinity()), srgb_from_linear(1));
    EXPECT_EQ(srgb_from_linear(-1), 0);
}

// The light goes through float, as in a frame buffer: its step near white, 6e-8, is 1/600 of the
// step between 16-bit codes there.
TEST(SrgbCurve, EveryCodeSurvivesTheRoundTripThroughFloatLight) {
    for (int code = 0; code <= 255; ++code) {
        const auto value = static_cast<float>(code / 255.0);
        const auto back = encode(decode({value, value, value}));
        ASSERT_EQ(code_8bit(static_cast<double>(back.g)), code);
    }
    for (int code = 0; code <= 65535; ++code) {
        const auto light = static_cast<float>(linear_from_srgb(code / 65535.0));
        ASSERT_EQ(code_16bit(srgb_from_linear(static_cast<double>(light))), code);
    }
}

// The standard's rounded constants leave a step of 3e-8 at the knee: 1/500 of a 16-bit code.
TEST(SrgbCurve, IsContinuousAtTheKnee) {
    const double above = std::nextafter(0.0031308, 1.0);
    EXPECT_LE(std::abs(srgb_from_linear(above) - srgb_from_linear(0.0031308)), 5e-8);
    const double encoded_above = std::nextafter(0.04045, 1.0);
    EXPECT_LE(std::abs(linear_from_srgb(encoded_above) - linear_from_srgb(0.04045)), 5e-8);
}

TEST(SrgbCurve, RisesEverywhere) {
    for (int code = 1; code <= 65535; ++code)
        ASSERT_LT(linear_from_srgb((code - 1) / 65535.0), linear_from_srgb(code / 65535.0));
}

TEST(Luminance, OfWhiteIsOneAndGreenWeighsMost) {
    EXPECT_NEAR(luminance({1, 1, 1}), 1, 1e-15);
    EXPECT_GT(luminance({0, 1, 0}), luminance({1, 0, 0}));
    EXPECT_GT(luminance({1, 0, 0}), luminance({0, 0, 1}));
}

TEST(Codes, RoundToTheNearest) {
    EXPECT_EQ(code_8bit(127.49 / 255), 127);
    EXPECT_EQ(code_8bit(127.51 / 255), 128);
    EXPECT_EQ(code_16bit(128 / 255.0), 128 * 257);
}

TEST(CodesDeathTest, RefuseWhatIsNoEncodedValue) {
    EXPECT_DEATH(code_8bit(std::nan("")), "expected encoded >= 0");
    EXPECT_DEATH(code_16bit(1.1), "expected encoded >= 0");
    EXPECT_DEATH(srgb_from_linear(std::nan("")), "isnan");
}

} // namespace
