#include "renderer/cost/picture_error.h"
#include "renderer/geometry/bodies.h"
#include "renderer/methods/constant.h"
#include "renderer/methods/traced.h"
#include "tests/renderer/methods/known_worlds.h"

namespace {

using namespace known_worlds;
using shading::Law;

imaging::LinearImage plain(LinearRgb light) {
    return {2, 2, std::vector<LinearRgb>(4, light), std::vector<float>(4, 1.0F)};
}

// (0.3^2 / (0.5^2 + 0.4^2 + 0.4^2))^(1/2)
TEST(RelativeRms, IsOfTheTruthsLight) {
    const std::vector<std::size_t> mask{0, 3};
    const auto error =
        cost::relative_rms(plain({0.2F, 0.4F, 0.4F}), plain({0.5F, 0.4F, 0.4F}), mask);
    EXPECT_NEAR(error, 0.3 / std::sqrt(0.57), 1e-7); // floats
    EXPECT_EQ(cost::relative_rms(plain({}), plain({1, 1, 1}), mask), 1);
    EXPECT_EQ(cost::relative_rms(plain({1, 1, 1}), plain({1, 1, 1}), mask), 0);
    EXPECT_TRUE(std::isnan(cost::relative_rms(plain({}), plain({}), mask)));
    EXPECT_TRUE(std::isnan(cost::relative_rms(plain({NAN, 1, 1}), plain({1, 1, 1}), mask)));
    EXPECT_EQ(cost::relative_rms(std::vector{1.0, 0.0}, std::vector{0.0, 1.0}), std::sqrt(2));
}

TEST(RelativeError, SaysWhenThereIsNone) {
    const std::vector<std::size_t> mask{0, 3};
    EXPECT_EQ(cost::relative_error(plain({}), plain({1, 1, 1}), mask).value(), 1);
    auto spoilt = plain({1, 1, 1});
    spoilt.pixels[3].g = NAN;
    EXPECT_EQ(cost::relative_error(spoilt, plain({1, 1, 1}), mask).error(),
              "1 of 2 pixels are no number");
    EXPECT_THAT(cost::relative_error(plain({}), plain({}), mask).error(),
                testing::HasSubstr("is black"));
}

class SeenThickness : public MethodTest {
  protected:
    geometry::Mesh sphere_ = geometry::sphere(1, 4);
    std::shared_ptr<const shading::Surface> surface_ = *shading::Surface::upload(sphere_);
};

// Red is the clearest channel of the colourful material, and exp of a float is right to 1e-6.
TEST_F(SeenThickness, IsWhatAConstantMethodWasGiven) {
    const auto scene = scene_of(sphere_, {0, 0, -1});
    const auto method = methods::prepare_constant({30, Law::Physical}, surface_, nullptr);
    const auto seen = cost::seen_thickness(**method, Law::Physical, scene, 33, 33);
    ASSERT_TRUE(seen);
    const double expected = 30 * effective_transport(scene.material.medium).r;
    int body = 0;
    for (const auto& d : *seen)
        if (d) {
            EXPECT_NEAR(*d, expected, 1e-5);
            ++body;
        }
    EXPECT_GT(body, 500);
    EXPECT_LT(body, 33 * 33); // the corners see past the sphere
}

TEST_F(SeenThickness, UnderThePapersLawIsAShareOfD_n) {
    thickness::ThicknessField field;
    field.d_n = 0.5; // of a radius of 1, 50 mm: 25 mm
    const auto method = methods::prepare_constant({10, Law::Paper}, surface_, &field);
    const auto seen =
        cost::seen_thickness(**method, Law::Paper, scene_of(sphere_, {0, 0, -1}), 33, 33);
    ASSERT_TRUE(seen);
    EXPECT_NEAR((*seen)[16 * 33 + 16].value(), 10.0 / 25, 1e-6);
}

TEST_F(SeenThickness, IsToldByNoPictureWhereNothingAbsorbs) {
    auto scene = scene_of(sphere_, {0, 0, -1});
    scene.material.medium.sigma_a = {0, 0, 0};
    const auto method = methods::prepare_constant({10, Law::Physical}, surface_, nullptr);
    const auto seen = cost::seen_thickness(**method, Law::Physical, scene, 9, 9);
    ASSERT_FALSE(seen);
    EXPECT_THAT(seen.error(), testing::HasSubstr("absorbs nothing"));
}

// Lit from behind, a ray into the picture at distance r from the axis meets the chord
// 2 sqrt(R^2 - r^2) along the axis; the facets of four subdivisions are within 0.5 % of the sphere.
TEST_F(SeenThickness, OfTracedThicknessIsTheChord) {
    const auto scene = scene_of(sphere_, {0, 0, -1});
    const auto method = methods::prepare_traced({}, surface_, sphere_, nullptr);
    ASSERT_TRUE(method) << method.error();
    const auto seen = cost::seen_thickness(**method, Law::Physical, scene, 33, 33);
    ASSERT_TRUE(seen) << seen.error();
    const double sigma = effective_transport(scene.material.medium).r;
    int checked = 0;
    for (const int column : {16, 20, 24}) {
        const auto hit = seen_by_pixel(sphere_, scene, column, 16, 33, 33);
        ASSERT_TRUE(hit);
        const double r = std::hypot(hit->point.x, hit->point.y);
        EXPECT_NEAR((*seen)[static_cast<std::size_t>(16 * 33 + column)].value() / sigma,
                    2 * std::sqrt(50 * 50 - r * r), 1.0)
            << column;
        ++checked;
    }
    EXPECT_EQ(checked, 3);
}

} // namespace
