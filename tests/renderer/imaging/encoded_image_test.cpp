#include "renderer/imaging/colour.h"
#include "renderer/imaging/encoded_image.h"

#include <cmath>
#include <set>

namespace {

using namespace renderer;
using namespace renderer::imaging;

LinearImage uniform(int width, int height, LinearRgb light) {
    const auto count = static_cast<std::size_t>(width * height);
    return {width, height, std::vector<LinearRgb>(count, light), std::vector<float>(count, 1.0F)};
}

LinearRgb grey(double encoded) {
    const auto light = static_cast<float>(linear_from_srgb(encoded));
    return {light, light, light};
}

TEST(EncodedImage, SixteenBitsHoldTheNearestCode) {
    const auto image = encode_16bit(uniform(1, 1, {0, 1, 2}));
    EXPECT_EQ(image.codes, (std::vector<std::uint16_t>{0, 65535, 65535}));
    EXPECT_EQ(image.bits, 16);
}

TEST(EncodedImage, LightComesBackFromItsCodes) {
    const auto image = encode_16bit(uniform(2, 1, {0.1F, 0.2F, 0.7F}));
    const auto light = light_at(image, 1);
    EXPECT_NEAR(light.r, 0.1, 2e-5); // half a code: 7.6e-6 times the curve's slope, 2.3 at most
    EXPECT_NEAR(light.g, 0.2, 2e-5);
    EXPECT_NEAR(light.b, 0.7, 2e-5);
}

// Whatever is an 8-bit code already must reach the display as it is, at every place of the tile.
TEST(Dither, LeavesExactCodesAlone) {
    for (int code = 0; code <= 255; ++code) {
        const auto image = encode_8bit(uniform(8, 8, grey(code / 255.0)));
        ASSERT_EQ(std::set<int>(image.codes.begin(), image.codes.end()), std::set<int>{code});
    }
}

// 64 thresholds, each once: a value q/64 of the way between two codes takes the upper one in q of
// 64 pixels.
TEST(Dither, KeepsTheMeanOfEveryTile) {
    for (int q = 0; q < 64; ++q) {
        const auto image = encode_8bit(uniform(8, 8, grey((100 + q / 64.0) / 255)));
        int upper = 0;
        for (const auto code : image.codes)
            upper += code == 101 ? 1 : 0;
        ASSERT_EQ(upper, 3 * q);
    }
}

// The first places of the tile, by Bayer's recursion [[0, 2], [3, 1]].
TEST(Dither, HasBayersTile) {
    const auto image = encode_8bit(uniform(8, 8, grey((100 + 63.0 / 64) / 255)));
    for (std::size_t pixel = 0; pixel < 64; ++pixel)
        ASSERT_EQ(image.codes[3 * pixel], pixel == 0 ? 100 : 101) << pixel;
    const auto half = encode_8bit(uniform(8, 8, grey(100.5 / 255)));
    for (std::size_t pixel = 0; pixel < 64; ++pixel) // ranks 32 and above are a chequerboard
        ASSERT_EQ(half.codes[3 * pixel], (pixel % 8 + pixel / 8) % 2 == 0 ? 100 : 101) << pixel;
}

TEST(EncodedImageDeathTest, RefusesLightThatIsNotANumber) {
    EXPECT_DEATH(encode_16bit(uniform(1, 1, {std::nanf(""), 0, 0})), "isnan");
    EXPECT_DEATH(encode_8bit(uniform(1, 1, {std::nanf(""), 0, 0})), "isnan");
}

} // namespace
