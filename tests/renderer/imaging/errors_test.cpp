// Measures on pictures whose errors can be worked out by hand.
#include "renderer/imaging/colour.h"
#include "renderer/imaging/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace {

using namespace renderer::imaging;
using renderer::LinearRgb;

LinearImage plain(LinearRgb light, int width = 40, int height = 30) {
    const auto n = static_cast<std::size_t>(width * height);
    return {width, height, std::vector<LinearRgb>(n, light), std::vector<float>(n, 1.0f)};
}

std::vector<std::size_t> everywhere(const LinearImage& image) {
    std::vector<std::size_t> mask(image.pixels.size());
    std::iota(mask.begin(), mask.end(), 0u);
    return mask;
}

ImageErrors errors_of(const LinearImage& x, const LinearImage& y, const ErrorSettings& s = {}) {
    const auto errors = image_errors(x, y, everywhere(y), s);
    EXPECT_TRUE(errors) << (errors ? "" : errors.error());
    return errors.value_or(ImageErrors{});
}

TEST(ImageErrors, OfEqualPicturesAreNone) {
    const auto image = plain({0.2f, 0.5f, 0.1f});
    const auto e = errors_of(image, image);
    EXPECT_EQ(e.rmse, 0);
    EXPECT_EQ(e.mae, 0);
    EXPECT_EQ(e.rel_mse, 0);
    EXPECT_TRUE(std::isinf(e.psnr));
    EXPECT_NEAR(e.ssim, 1, 1e-6);
    EXPECT_EQ(e.ldr_flip, 0);
    EXPECT_EQ(e.hdr_flip, 0);
}

// One channel of three is off by 0.3: squares 0.09 / 3, sizes 0.3 / 3; the reference there is 0.2.
TEST(ImageErrors, InLightAreWorkedOutByHand) {
    const auto e = errors_of(plain({0.5f, 0.4f, 0.4f}), plain({0.2f, 0.4f, 0.4f}));
    EXPECT_NEAR(e.rmse, std::sqrt(0.03), 1e-7);
    EXPECT_NEAR(e.mae, 0.1, 1e-7);
    EXPECT_NEAR(e.rel_mse, 0.09 / (0.04 + 0.01) / 3, 1e-6);
    const double d = srgb_from_linear(0.5) - srgb_from_linear(0.2);
    EXPECT_NEAR(e.psnr, -10 * std::log10(d * d / 3), 1e-5);
}

// Even pictures have no structure: SSIM is (2ab + c) / (a^2 + b^2 + c) of the encoded brightness.
TEST(Ssim, OfEvenPicturesComparesTheirMeans) {
    const double a = srgb_from_linear(0.5), b = srgb_from_linear(0.25), c = 1e-4;
    const auto e = errors_of(plain({0.5f, 0.5f, 0.5f}), plain({0.25f, 0.25f, 0.25f}));
    EXPECT_NEAR(e.ssim, (2 * a * b + c) / (a * a + b * b + c), 1e-4); // squares in float: 6e-8 over c2 = 9e-4
}

// A negative of a fine checkerboard: equal means, opposite structure.
TEST(Ssim, OfOppositeStructureIsNegative) {
    auto x = plain({0, 0, 0}), y = x;
    for (int i = 0; i < x.width * x.height; ++i) {
        const bool is_light = (i % x.width + i / x.width) % 2 == 0;
        const float light = 0.8f, dark = 0.2f;
        x.pixels[static_cast<std::size_t>(i)] =
            is_light ? LinearRgb{light, light, light} : LinearRgb{dark, dark, dark};
        y.pixels[static_cast<std::size_t>(i)] =
            is_light ? LinearRgb{dark, dark, dark} : LinearRgb{light, light, light};
    }
    EXPECT_LT(errors_of(x, y).ssim, -0.9);
}

// Green against blue is the greatest colour difference there is: 1 by definition, and even
// pictures have no features.
TEST(Flip, OfGreenAgainstBlueIsOne) {
    const auto map = ldr_flip(plain({0, 1, 0}), plain({0, 0, 1}), default_pixels_per_degree);
    for (const float value : map.values)
        EXPECT_NEAR(value, 1, 1e-4);
}

// Greys differ in lightness alone.  White against black: 100^0.7 = 25.12.  Green and blue, Hunt
// adjusted: Lab (87.73, -75.62, 72.98) and (32.30, 25.59, -34.85) from (87.735, -86.18, 83.18) and
// (32.297, 79.19, -107.86); |dL| = 55.44, hypot(101.19, 107.83) = 147.87: 203.31^0.7 = 41.27.  The
// knee is at 0.4 of it, 16.51: 0.95 + 0.05 (25.12 - 16.51) / (41.27 - 16.51) = 0.96739.
TEST(Flip, OfWhiteAgainstBlackIsWorkedOutByHand) {
    const auto map = ldr_flip(plain({1, 1, 1}), plain({0, 0, 0}), default_pixels_per_degree);
    EXPECT_NEAR(map.at(20, 15), 0.96739, 2e-4);
}

// Lightness 50 against 51: 1^0.7 = 1, below the knee: 0.95 / 16.51 = 0.05755.
TEST(Flip, OfASmallStepIsBelowTheKnee) {
    const auto light = [](double lightness) {
        const auto y = static_cast<float>(std::pow((lightness + 16) / 116, 3));
        return plain({y, y, y});
    };
    const auto map = ldr_flip(light(50), light(51), default_pixels_per_degree);
    EXPECT_NEAR(map.at(3, 3), 0.05755, 5e-5);
}

// A single pixel's dot: colours blur it away, the feature detector does not.
TEST(Flip, SeesAPointAndForgetsItFarAway) {
    auto x = plain({0.2f, 0.2f, 0.2f}, 101, 61);
    const auto y = x;
    x.pixels[101 * 30 + 50] = {1, 1, 1};
    const auto map = ldr_flip(x, y, default_pixels_per_degree);
    EXPECT_GT(map.at(50, 30), 0.2);
    EXPECT_LT(map.at(5, 5), 1e-6);
    EXPECT_NEAR(map.at(40, 30), map.at(60, 30), 1e-5); // the same on both sides
}

// The brightest pixel and the median reach 0.85 of the curve: 0.85 needs light 1.0245 there.
TEST(HdrFlip, ExposesFromTheBrightestToTheMedian) {
    auto image = plain({1, 1, 1});
    image.pixels[7] = {16, 16, 16};
    const auto range = exposure_range(image);
    EXPECT_NEAR(range.last - range.first, 4, 1e-12);
    EXPECT_EQ(range.count, 4);
    EXPECT_NEAR(tone_mapped(std::exp2(range.last)), 0.85, 1e-12);
    EXPECT_NEAR(tone_mapped(16 * std::exp2(range.first)), 0.85, 1e-12);
}

TEST(HdrFlip, SeesDifferencesBeyondTheDisplay) {
    const auto x = plain({8, 8, 8}), y = plain({4, 4, 4});
    const auto e = errors_of(x, y);
    EXPECT_EQ(e.ldr_flip, 0); // both are white there
    EXPECT_GT(e.hdr_flip, 0.1);
}

TEST(ImageErrors, EqualisedForgetBrightness) {
    const auto e = errors_of(plain({0.4f, 0.2f, 0.1f}), plain({0.2f, 0.1f, 0.05f}),
                             {.brightness = Brightness::Equalised});
    EXPECT_NEAR(e.rmse, 0, 1e-7);
    EXPECT_LE(e.ldr_flip, 1e-3);
}

TEST(ImageErrors, LookAtTheMaskAlone) {
    auto x = plain({0.3f, 0.3f, 0.3f});
    const auto y = x;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    x.pixels[3] = {nan, 9, 9};
    std::vector<std::size_t> mask{200, 201, 202, 240, 241, 242};
    const auto errors = image_errors(x, y, mask);
    ASSERT_TRUE(errors) << errors.error();
    EXPECT_EQ(errors->rmse, 0);
    EXPECT_EQ(errors->hdr_flip, 0);
}

TEST(ImageErrors, NameWhatCannotBeCompared) {
    const auto good = plain({0.3f, 0.3f, 0.3f});
    const auto refusal = [&](const LinearImage& x, const LinearImage& y) {
        const auto errors = image_errors(x, y, everywhere(good));
        EXPECT_FALSE(errors);
        return errors ? std::string() : errors.error();
    };
    auto bad = good;
    bad.pixels[42] = {0, std::numeric_limits<float>::infinity(), 0};
    EXPECT_THAT(refusal(bad, good), testing::HasSubstr("the picture: pixel (2, 1) is (0, inf, 0)"));
    EXPECT_THAT(refusal(good, bad), testing::HasSubstr("the reference: pixel (2, 1)"));
    bad.pixels[42] = {0, 0, std::numeric_limits<float>::quiet_NaN()};
    EXPECT_THAT(refusal(bad, good), testing::HasSubstr("the picture: pixel (2, 1) is (0, 0, nan)"));
    EXPECT_THAT(refusal(plain({0, 0, 0}), good), testing::HasSubstr("the picture is black"));
    EXPECT_THAT(refusal(good, plain({0, 0, 0})), testing::HasSubstr("the reference is black"));
    EXPECT_THAT(refusal(good, plain({1, 1, 1}, 30, 40)), testing::HasSubstr("40 x 30"));
    EXPECT_THAT(image_errors(good, good, {}).error(), testing::HasSubstr("mask is empty"));
}

TEST(ErrorMap, GoesFromDarkToLight) {
    Plane plane(3, 1);
    plane.values = {0, 0.5f, 2};
    const auto map = error_map(plane, 0, 1);
    EXPECT_LT(luminance(map.pixels[0]), luminance(map.pixels[1]));
    EXPECT_LT(luminance(map.pixels[1]), luminance(map.pixels[2]));
    EXPECT_NEAR(luminance(map.pixels[2]), luminance(decode({0.99f, 0.91f, 0.30f})), 1e-5);
}

} // namespace
