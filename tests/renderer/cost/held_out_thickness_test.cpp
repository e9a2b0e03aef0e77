#include "renderer/cost/held_out_thickness.h"
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/simplify.h"
#include "renderer/methods/constant.h"
#include "renderer/methods/traced.h"
#include "tests/renderer/methods/known_worlds.h"

#include <epoxy/gl.h>

#include <limits>

namespace {

using namespace known_worlds;
using shading::Law;

class HeldOut : public MethodTest {
  protected:
    geometry::Mesh sphere_ = geometry::sphere(1, 4);
    std::shared_ptr<const shading::Surface> surface_ = *shading::Surface::upload(sphere_);

    std::unique_ptr<methods::Method> constant(double mm) const {
        return std::move(*methods::prepare_constant({mm, Law::Physical}, surface_, nullptr));
    }

    cost::HeldOutThickness from(methods::Method& exact) const {
        return *cost::HeldOutThickness::prepare(exact, Law::Physical, scene_of(sphere_, {0, 0, -1}),
                                                33, 33, 3, 2);
    }
};

/// Covers the picture with what is no number.
class Broken : public methods::Method {
  public:
    Expected<void> update(const Scene&, double) override { return {}; }

    void draw(const Scene&) override {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const std::array<float, 4> colour{nan, nan, nan, 1};
        glClearBufferfv(GL_COLOR, 0, colour.data());
    }

    methods::Cost cost() const override { return {}; }
};

// 33 mm instead of 30 everywhere are a tenth; exp of a float is right to 1e-6.
TEST_F(HeldOut, IsRelativeToTheTruth) {
    const auto truth = constant(30);
    const auto held_out = from(*truth);
    EXPECT_NEAR(held_out.error_of(*constant(33)).value(), 0.1, 1e-5);
    EXPECT_EQ(held_out.error_of(*truth).value(), 0);
}

TEST_F(HeldOut, SaysThatWhatIsNoNumberIsNone) {
    const auto truth = constant(30);
    Broken broken;
    const auto error = from(*truth).error_of(broken);
    ASSERT_FALSE(error);
    EXPECT_THAT(error.error(), testing::MatchesRegex("the thickness is no number at ([0-9]+) of "
                                                     "[0-9]+ pixels"));
}

// 320 triangles on the unit sphere have edges of h = 0.3.  Where 2 cos begins, interpolating over
// an edge is off by at most h/2, on a band of h, 15 % of what has thickness; facets lie h^2/6
// inside at either end.  The truth's root mean square is (2/3)^(1/2) = 0.82:
// ((0.15 * 0.15^(1/2))^2 + 0.03^2)^(1/2) / 0.82 = 8 %, and a quarter more for uneven triangles.
TEST_F(HeldOut, MeasuresASimplifiedMeshByTheWholeOne) {
    const auto exact = *methods::prepare_traced({}, surface_, sphere_, nullptr);
    const auto held_out = from(*exact);
    const auto error = [&](std::size_t triangles) {
        const auto coarse = *geometry::simplify(sphere_, triangles);
        const auto rough =
            *methods::prepare_traced({}, *shading::Surface::upload(coarse), coarse, nullptr);
        return held_out.error_of(*rough).value();
    };
    EXPECT_LE(error(320), 0.1);
    EXPECT_LT(error(1280), error(320));
    EXPECT_GT(error(1280), 0); // it is not the same surface
}

} // namespace
