#include "experiment/viewer/false_colours.h"

#include <cmath>

namespace {

using namespace experiment::viewer;
using renderer::Millimetres;

struct Lab {
    double L, a, b;
};

// From linear sRGB, the way false_colour does not go.  [Ottosson2020]
Lab oklab(const renderer::LinearRgb& light) {
    const double r = static_cast<double>(light.r), g = static_cast<double>(light.g),
                 b = static_cast<double>(light.b);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double apart(const Lab& x, const Lab& y) {
    return std::hypot(x.L - y.L, x.a - y.a, x.b - y.b);
}

TEST(FalseColours, TakeEqualStepsAndGrowLighter) {
    constexpr int steps = 64;
    const double first = apart(oklab(false_colour(0)), oklab(false_colour(1.0 / steps)));
    ASSERT_GT(first, 0.01);
    for (int i = 1; i < steps; ++i) {
        const auto here = oklab(false_colour(static_cast<double>(i) / steps));
        const auto next = oklab(false_colour(static_cast<double>(i + 1) / steps));
        // Ten digits in the matrices, seven in a float that is 0.002 at the least.
        EXPECT_NEAR(apart(here, next), first, 1e-3 * first) << i;
        EXPECT_GT(next.L, here.L);
    }
}

TEST(FalseColours, CanBeShown) {
    for (int i = 0; i <= 255; ++i) {
        const auto [r, g, b] = false_colour(i / 255.0);
        for (const float channel : {r, g, b}) {
            EXPECT_GE(channel, 0) << i;
            EXPECT_LE(channel, 1) << i;
        }
    }
}

TEST(FalseColours, EndWhereTheScaleEnds) {
    EXPECT_EQ(false_colour(-3), false_colour(0));
    EXPECT_EQ(false_colour(7), false_colour(1));
}

TEST(Scale, IsTheNextOfOneTwoAndFive) {
    EXPECT_DOUBLE_EQ(round_scale(0.013), 0.02);
    EXPECT_DOUBLE_EQ(round_scale(2), 2);
    EXPECT_DOUBLE_EQ(round_scale(2.001), 2);
    EXPECT_DOUBLE_EQ(round_scale(2.01), 5);
    EXPECT_DOUBLE_EQ(round_scale(51), 100);
    EXPECT_DOUBLE_EQ(round_scale(99.8), 100);
    EXPECT_EQ(round_scale(0), 1);
    EXPECT_EQ(round_scale(NAN), 1);
}

TEST(ThicknessProbe, HasTheTransportThatItPromises) {
    const auto sigma = renderer::effective_transport(thickness_probe(Millimetres{40}).medium);
    EXPECT_NEAR(sigma.r, 1.0 / 40, 1e-12);
    EXPECT_NEAR(sigma.g, 2.0 / 40, 1e-12);
    EXPECT_NEAR(sigma.b, 3.0 / 40, 1e-12);
}

std::array<float, 4> dimmed(double d, double reach, double brightness) {
    const auto channel = [&](double n) {
        return static_cast<float>(brightness * std::exp(-n * d / reach));
    };
    return {channel(1), channel(2), channel(3), 1};
}

// r/g is known to 2 roundings of a float: d to reach * 1.2e-7.
TEST(ThicknessProbe, IsReadWhateverTheBrightness) {
    for (const double d : {0.0, 0.3, 10.0, 100.0, 300.0})
        for (const double brightness : {1e-3, 1.0, 50.0}) {
            const auto read = thickness_of(dimmed(d, 100, brightness), Millimetres{100});
            ASSERT_TRUE(read) << d;
            EXPECT_NEAR(*read, d, 100 * 1.2e-7 * 2);
        }
}

TEST(ThicknessProbe, ReadsNothingWhereNoSingleThicknessDimsTheLight) {
    const Millimetres reach{100};
    EXPECT_FALSE(thickness_of(std::array{0.0F, 0.0F, 0.0F, 0.0F}, reach)); // nothing there
    EXPECT_FALSE(thickness_of(std::array{0.0F, 0.0F, 0.0F, 1.0F}, reach)); // no light
    EXPECT_FALSE(thickness_of(std::array{0.9F, 0.5F, 0.4F, 1.0F}, reach));
    EXPECT_FALSE(thickness_of(std::array{NAN, 0.5F, 0.4F, 1.0F}, reach));
    // The mean of two exponentials is none.
    const auto thin = dimmed(10, 100, 1), thick = dimmed(90, 100, 1);
    std::array<float, 4> mean{};
    for (std::size_t i = 0; i < 4; ++i)
        mean[i] = (thin[i] + thick[i]) / 2;
    EXPECT_FALSE(thickness_of(mean, reach));
}

TEST(ThicknessSeen, IsTheBodysMeanAndMost) {
    std::vector<float> picture(4, 0.0F); // one empty pixel
    for (const double d : {10.0, 30.0})
        for (const float channel : dimmed(d, 100, 1))
            picture.push_back(channel);
    const auto seen = thickness_seen(picture, Millimetres{100});
    EXPECT_EQ(seen.pixels, 2U);
    EXPECT_EQ(seen.known, 2U);
    EXPECT_NEAR(seen.mean, 20, 1e-4);
    EXPECT_NEAR(seen.most, 30, 1e-4);
    EXPECT_TRUE(has_thickness(seen));
    EXPECT_FALSE(has_thickness({.pixels = 100, .known = 98}));
}

TEST(ErrorSeen, IsTheLargestChannelWhereEitherShowsTheBody) {
    const std::vector<float> left{0.5F, 0.5F, 0.5F, 1, 0, 0, 0, 0, 0.25F, 0, 0, 1};
    const std::vector<float> right{0.5F, 0.75F, 0.375F, 1, 0, 0, 0, 0, 0, 0, 0, 0};
    const auto seen = error_seen(left, right);
    EXPECT_EQ(seen.mean, 0.25);
    EXPECT_EQ(seen.most, 0.25);
}

TEST(ErrorSeen, DoesNotHideABrokenPixel) {
    const std::vector<float> left{0.5F, NAN, 0.5F, 1, 0.5F, 0.5F, 0.5F, 1};
    const std::vector<float> right{0.5F, 0.5F, 0.25F, 1, 0.5F, 0.5F, 0.5F, 1};
    EXPECT_TRUE(std::isnan(error_seen(left, right).most));
    EXPECT_TRUE(std::isnan(error_seen(left, right).mean));
}

} // namespace
