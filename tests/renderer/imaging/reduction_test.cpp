#include "renderer/imaging/colour.h"
#include "renderer/imaging/reduction.h"

#include <set>

namespace {

using namespace renderer::imaging;

EncodedImage uniform(int width, int height, std::uint16_t code) {
    return {width, height, 8,
            std::vector<std::uint16_t>(static_cast<std::size_t>(3 * width * height), code)};
}

TEST(Reduction, KeepsEvenPicturesEvenAndTheirShape) {
    const auto small = reduced(uniform(97, 61, 128), 24);
    EXPECT_EQ(small.width, 24);
    EXPECT_EQ(small.height, 15); // 61 24/97 = 15.09
    EXPECT_EQ(std::set<int>(small.codes.begin(), small.codes.end()), std::set<int>{128});
}

TEST(Reduction, NeverEnlarges) {
    const auto same = reduced(uniform(5, 3, 77), 100);
    EXPECT_EQ(same.width, 5);
    EXPECT_EQ(same.codes, uniform(5, 3, 77).codes);
}

// A fine chequerboard of black and white seen from afar is half the light: code 188, not 128.
TEST(Reduction, AveragesLight) {
    auto board = uniform(64, 64, 0);
    for (std::size_t pixel = 0; pixel < 64 * 64; ++pixel)
        if ((pixel % 64 + pixel / 64) % 2 == 0)
            for (std::size_t channel = 0; channel < 3; ++channel)
                board.codes[3 * pixel + channel] = 255;
    const auto small = reduced(board, 16);
    ASSERT_EQ(small.width, 16);
    for (const auto code : small.codes)
        ASSERT_NEAR(code, 188, 1); // half the light is 187.5, dithered
}

TEST(Reduction, LeavesAPixelAtLeast) {
    const auto line = reduced(uniform(1000, 1, 9), 10);
    EXPECT_EQ(line.width, 10);
    EXPECT_EQ(line.height, 1);
}

} // namespace
