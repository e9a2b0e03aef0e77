#include "renderer/pictures/fitting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace renderer;
using namespace renderer::pictures;
using imaging::LinearImage;

constexpr int width = 24, height = 16;

/// Uniform over [0, 1), the same with every standard library.
float share(std::mt19937_64& random) {
    return static_cast<float>(random() >> 40) * 0x1p-24F;
}

LinearImage random_picture(std::mt19937_64& random) {
    LinearImage image{width, height, {}, std::vector<float>(width * height, 1.0F)};
    for (int i = 0; i < width * height; ++i)
        image.pixels.push_back({share(random), share(random), share(random)});
    return image;
}

const Reflectance truth{.ambient = {0.02F, 0.03F, 0.04F},
                        .diffuse = {0.5F, 0.4F, 0.3F},
                        .specular = {0.2F, 0.25F, 0.3F},
                        .scatter = {0.6F, 0.7F, 0.8F}};

/// terms[0] ambient + ... with these k's, in double and rounded once.
LinearImage sum_of(const std::array<LinearImage, 4>& terms, const Reflectance& k) {
    auto sum = terms[0];
    const std::array coefficients{k.ambient, k.diffuse, k.specular, k.scatter};
    for (std::size_t i = 0; i < sum.pixels.size(); ++i)
        for (const auto channel : {&LinearRgb::r, &LinearRgb::g, &LinearRgb::b}) {
            double light = 0;
            for (std::size_t j = 0; j < terms.size(); ++j)
                light += static_cast<double>(coefficients[j].*channel) *
                         static_cast<double>(terms[j].pixels[i].*channel);
            sum.pixels[i].*channel = static_cast<float>(light);
        }
    return sum;
}

LightPictures known_light(unsigned seed) {
    std::mt19937_64 random(seed);
    LightPictures pictures;
    for (auto& term : pictures.terms)
        term = random_picture(random);
    pictures.target = sum_of(pictures.terms, truth);
    return pictures;
}

void expect_near(LinearRgb found, LinearRgb expected, float tolerance) {
    EXPECT_NEAR(found.r, expected.r, tolerance);
    EXPECT_NEAR(found.g, expected.g, tolerance);
    EXPECT_NEAR(found.b, expected.b, tolerance);
}

void expect_near(const Reflectance& found, const Reflectance& expected, float tolerance) {
    expect_near(found.ambient, expected.ambient, tolerance);
    expect_near(found.diffuse, expected.diffuse, tolerance);
    expect_near(found.specular, expected.specular, tolerance);
    expect_near(found.scatter, expected.scatter, tolerance);
}

/// The complaint about one training light.
std::string complaint(const LightPictures& pictures) {
    const auto added = ReflectanceFit().add_training_light(pictures);
    EXPECT_FALSE(added);
    return added ? "" : added.error();
}

TEST(ReflectanceFit, GivesBackTheCoefficientsThePicturesWereMadeWith) {
    ReflectanceFit fit;
    for (const unsigned seed : {1U, 2U, 3U})
        ASSERT_TRUE(fit.add_training_light(known_light(seed)));
    const auto best = fit.best();
    expect_near(best.reflectance, truth, 1e-6F); // the targets are rounded to float
    EXPECT_THAT(best.absent, testing::IsEmpty());
    EXPECT_LE(best.training_error.mean(), 1e-13);
    EXPECT_LE(fit_error(best.reflectance, known_light(4))->mean(), 1e-12);
}

TEST(ReflectanceFit, NamesATermTheMethodDoesNotHave) {
    auto light = known_light(5);
    for (auto& pixel : light.terms[3].pixels)
        pixel = {};
    ReflectanceFit fit;
    ASSERT_TRUE(fit.add_training_light(light)); // the target still has scattered light
    const auto best = fit.best();
    EXPECT_THAT(best.absent, testing::ElementsAre(Term::Scatter));
    EXPECT_EQ(name(best.absent.front()), "scatter");
    EXPECT_EQ(best.reflectance.scatter, (LinearRgb{0, 0, 0}));
    EXPECT_GT(best.training_error.mean(), 1e-3);
}

TEST(ReflectanceFit, DoesNotNameATermTheTargetHasNoUseFor) {
    auto light = known_light(6);
    auto k = truth;
    k.specular = {};
    light.target = sum_of(light.terms, k);
    ReflectanceFit fit;
    ASSERT_TRUE(fit.add_training_light(light));
    expect_near(fit.best().reflectance, k, 1e-6F);
    EXPECT_THAT(fit.best().absent, testing::IsEmpty());
}

// The mean of (x - y)^2/(y^2 + 0.01) over the pixels, worked out on its own.
TEST(ReflectanceFit, ReportsRelMse) {
    auto light = known_light(7);
    for (std::size_t i = 0; i < light.target.pixels.size(); ++i)
        light.target.pixels[i].g *= i % 2 == 0 ? 1.1F : 0.9F;
    ReflectanceFit fit;
    ASSERT_TRUE(fit.add_training_light(light));
    const auto best = fit.best();
    const auto picture = sum_of(light.terms, best.reflectance);
    double sum = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const auto x = static_cast<double>(picture.pixels[i].g);
        const auto y = static_cast<double>(light.target.pixels[i].g);
        sum += (x - y) * (x - y) / (y * y + 0.01);
    }
    sum /= width * height;
    EXPECT_GT(sum, 1e-3);
    EXPECT_NEAR(best.training_error.rgb[1], sum, 1e-6);
    EXPECT_NEAR(fit_error(best.reflectance, light)->rgb[1], sum, 1e-6);
    // No other k's do better on the light they were fitted to.
    EXPECT_GT(fit_error(truth, light)->rgb[1], sum);
}

TEST(ReflectanceFit, LooksOnlyAtPixelsThatAllPicturesCover) {
    auto light = known_light(8);
    for (std::size_t i = 0; i < 40; ++i) {
        auto& image = i % 2 == 0 ? light.target : light.terms[i / 2 % 4];
        image.coverage[i] = 0.5F;
        image.pixels[i] = {1e6F, std::numeric_limits<float>::quiet_NaN(), 0};
    }
    ReflectanceFit fit;
    ASSERT_TRUE(fit.add_training_light(light));
    expect_near(fit.best().reflectance, truth, 1e-6F);
}

TEST(ReflectanceFit, RefusesPicturesThatDoNotBelongTogether) {
    auto other_size = known_light(9);
    other_size.terms[2] = {1, 1, {{}}, {1}};
    EXPECT_EQ(complaint(other_size),
              "a picture of 1 x 1 pixels beside a target of 24 x 16, expected one size");
    auto nothing = known_light(9);
    std::fill(nothing.target.coverage.begin(), nothing.target.coverage.end(), 0.0F);
    EXPECT_THAT(complaint(nothing), testing::StartsWith("no pixel that the pictures and their"));
    auto broken = known_light(9);
    broken.terms[1].pixels[2 * width + 5].b = std::numeric_limits<float>::infinity();
    EXPECT_EQ(complaint(broken), "pixel (5, 2) is not a number, expected light");
}

TEST(ReflectanceFit, IsNotSpoiltByALightItRefused) {
    ReflectanceFit fit;
    ASSERT_TRUE(fit.add_training_light(known_light(1)));
    auto broken = known_light(2);
    broken.target.pixels.back().b = std::numeric_limits<float>::quiet_NaN();
    ASSERT_FALSE(fit.add_training_light(broken));
    EXPECT_LE(fit.best().training_error.mean(), 1e-13);
}

} // namespace
