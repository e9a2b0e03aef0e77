#include "renderer/imaging/brightness.h"
#include "renderer/imaging/colour.h"

#include <cmath>
#include <limits>

namespace {

using namespace renderer;
using namespace renderer::imaging;
using testing::HasSubstr;

constexpr int edge = 100;

LinearImage filled(LinearRgb light) {
    const auto count = static_cast<std::size_t>(edge * edge);
    return {edge, edge, std::vector<LinearRgb>(count, light), std::vector<float>(count, 1.0F)};
}

LinearImage grey(float light) {
    return filled({light, light, light});
}

std::vector<std::size_t> whole_mask() {
    return covered_pixels(grey(0).coverage);
}

TEST(Mask, HoldsThePixelsThatAreWhollyCovered) {
    const std::vector<float> coverage{0, 0.5F, 0.9989F, 0.999F, 1};
    EXPECT_EQ(covered_pixels(coverage), (std::vector<std::size_t>{3, 4}));
}

TEST(Brightness, MeanIsThatOfLuminanceInsideTheMask) {
    auto image = filled({0, 0.5F, 0});
    image.pixels[0] = {1, 1, 1}; // outside the mask
    image.coverage[0] = 0.5F;
    EXPECT_NEAR(mean_luminance(image, covered_pixels(image.coverage)), 0.3576, 1e-12);
}

TEST(Brightness, WithoutAReferenceMeetsAtTheGeometricMean) {
    const auto dark = grey(0.1F);
    const auto bright = grey(0.4F);
    const std::vector<NamedImage> pictures{{"dark", dark}, {"bright", bright}};
    const auto matches = match_brightness(pictures, whole_mask());
    ASSERT_TRUE(matches.has_value()) << matches.error();
    ASSERT_EQ(matches->size(), 2U);
    for (const auto& match : *matches) { // tolerances: 0.1 and 0.4 as floats
        EXPECT_NEAR(match.target, 0.2, 1e-8);
        EXPECT_NEAR(match.mean_after, 0.2, 1e-7);
        EXPECT_EQ(match.clipped_share, 0);
    }
    EXPECT_NEAR((*matches)[0].gain, 2.0, 1e-7);
    EXPECT_NEAR((*matches)[1].gain, 0.5, 1e-7);
    EXPECT_NEAR((*matches)[0].mean_before, 0.1, 1e-8);
}

TEST(Brightness, MeetsAtTheReferencesMeanWhereThereIsOne) {
    const auto image = grey(0.1F);
    const auto matches =
        match_brightness(std::vector<NamedImage>{{"only", image}}, whole_mask(), 0.3);
    ASSERT_TRUE(matches.has_value()) << matches.error();
    EXPECT_EQ(matches->front().target, 0.3);
    EXPECT_NEAR(matches->front().gain, 3.0, 1e-7);
}

TEST(Brightness, GainKeepsColour) {
    const auto red = filled({0.2F, 0.05F, 0.05F});
    const auto opaque = composite_over_grey(red, 2.5, 128);
    EXPECT_NEAR(opaque.pixels[7].r, 0.5, 1e-7);
    EXPECT_NEAR(opaque.pixels[7].r / opaque.pixels[7].b, 4, 1e-6);
}

// One picture has `bright` pixels of light 8 among 0.1: they clip unless the target falls to an
// eighth of its mean.
LinearImage spotted(std::size_t bright) {
    auto image = grey(0.1F);
    for (std::size_t pixel = 0; pixel < bright; ++pixel)
        image.pixels[pixel * 7] = {8, 8, 8};
    return image;
}

TEST(Brightness, AllowsOnePixelInAThousandToClip) {
    const auto image = spotted(edge * edge / 1000);
    const auto plain = grey(0.2F);
    const std::vector<NamedImage> pictures{{"spotted", image}, {"plain", plain}};
    const auto matches = match_brightness(pictures, whole_mask(), 0.2);
    ASSERT_TRUE(matches.has_value()) << matches.error();
    EXPECT_EQ(matches->front().target, 0.2);
    EXPECT_NEAR(matches->front().clipped_share, 0.001, 1e-12);
    EXPECT_LT(matches->front().mean_after, 0.2); // what clips is not shown
}

TEST(Brightness, LowersTheTargetForAllRatherThanClipOne) {
    const auto image = spotted(edge * edge / 1000 + 1);
    const auto plain = grey(0.2F);
    for (const bool spotted_first : {true, false}) {
        std::vector<NamedImage> pictures{{"spotted", image}, {"plain", plain}};
        if (!spotted_first)
            pictures = {{"plain", plain}, {"spotted", image}};
        const auto matches = match_brightness(pictures, whole_mask(), 0.2);
        ASSERT_TRUE(matches.has_value()) << matches.error();
        const auto& of_spotted = (*matches)[spotted_first ? 0 : 1];
        const auto& of_plain = (*matches)[spotted_first ? 1 : 0];
        EXPECT_EQ(of_spotted.target, of_plain.target);
        EXPECT_EQ(of_spotted.clipped_share, 0);
        EXPECT_LE(8 * of_spotted.gain, 1);        // nothing clips any more,
        EXPECT_GT(8 * of_spotted.gain / 0.95, 1); // and one step higher it would
        EXPECT_NEAR(of_plain.mean_after, of_plain.target, 1e-6 * of_plain.target);
        const double steps = std::log(of_plain.target / 0.2) / std::log(0.95);
        EXPECT_NEAR(steps, std::round(steps), 1e-9); // factors of 0.95 and nothing else
    }
}

TEST(Brightness, RefusesABlackPictureByName) {
    const auto black = grey(0.9e-4F);
    const auto plain = grey(0.2F);
    const std::vector<NamedImage> pictures{{"plain", plain}, {"green", black}};
    const auto matches = match_brightness(pictures, whole_mask());
    ASSERT_FALSE(matches.has_value());
    EXPECT_THAT(matches.error(), HasSubstr("picture 'green' is black"));
}

TEST(Brightness, RefusesLightThatIsNoneAndNamesThePixel) {
    for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity(), -0.5F}) {
        auto image = grey(0.2F);
        image.pixels[3 * edge + 14].g = bad;
        const auto matches =
            match_brightness(std::vector<NamedImage>{{"shss", image}}, whole_mask());
        ASSERT_FALSE(matches.has_value());
        EXPECT_THAT(matches.error(), HasSubstr("picture 'shss': pixel (14, 3) is (0.2, "));
    }
}

TEST(Brightness, RefusesAnEmptyMask) {
    const auto image = grey(0.2F);
    const auto matches = match_brightness(std::vector<NamedImage>{{"shss", image}}, {});
    ASSERT_FALSE(matches.has_value());
    EXPECT_THAT(matches.error(), HasSubstr("no pixel is wholly covered"));
}

// Premultiplied light, half covered: gain acts on the object only, the grey shines through.
TEST(Surround, BlendsInLinearLightAfterTheGain) {
    LinearImage image{3, 1, {{0, 0, 0}, {0.1F, 0.1F, 0.1F}, {0.2F, 0.2F, 0.2F}}, {0, 0.5F, 1}};
    const auto opaque = composite_over_grey(image, 2.0, 128);
    const double surround = linear_from_srgb(128 / 255.0);
    EXPECT_NEAR(opaque.pixels[0].g, surround, 1e-7);
    EXPECT_NEAR(opaque.pixels[1].g, 0.2 + 0.5 * surround, 1e-7);
    EXPECT_NEAR(opaque.pixels[2].g, 0.4, 1e-7);
    EXPECT_EQ(opaque.coverage, std::vector<float>(3, 1.0F));
    EXPECT_EQ(encode_8bit(opaque).codes[0], 128);
    EXPECT_EQ(encode_16bit(opaque).codes[0], 128 * 257);
}

// A ramp over the darker half, where 8 bits are coarsest: dither keeps the mean, and a picture of
// another brightness is found out.
TEST(EncodedMean, StaysWithinTheToleranceWhenDithered) {
    auto image = grey(0);
    for (std::size_t pixel = 0; pixel < image.pixels.size(); ++pixel) {
        const float light = 0.002F + 0.3F * static_cast<float>(pixel % edge) / edge;
        image.pixels[pixel] = {light, light, light};
    }
    const auto mask = whole_mask();
    const double target = mean_luminance(image, mask);
    const auto encoded = encode_8bit(image);
    const auto mean = check_encoded_mean("ramp", encoded, mask, target);
    ASSERT_TRUE(mean.has_value()) << mean.error();
    EXPECT_NEAR(*mean, target, 2e-3 * target);
    const auto wrong = check_encoded_mean("ramp", encoded, mask, target * 1.003);
    ASSERT_FALSE(wrong.has_value());
    EXPECT_THAT(wrong.error(), HasSubstr("picture 'ramp': mean luminance after encoding is"));
    EXPECT_FALSE(check_encoded_mean("ramp", encoded, mask, std::nan("")).has_value());
}

} // namespace
