// Methods as the viewer keeps them, and the thickness that it reads out of their pictures.
#include "experiment/viewer/false_colours.h"
#include "experiment/viewer/stage.h"
#include "experiment/viewer/viewpoint.h"
#include "renderer/gpu/context.h"
#include "renderer/gpu/target.h"
#include "renderer/methods/catalogue.h"
#include "tests/experiment/viewer/small_exhibit.h"

#include <memory>

namespace {

using namespace experiment::viewer;
namespace gpu = renderer::gpu;

constexpr int size = 64;
constexpr renderer::Millimetres reach{100};

class StageTest : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(context_) << context_.error();
        auto stage = Stage::open(exhibit_, exhibit_.pieces[0], [this](double) { ++told_; });
        ASSERT_TRUE(stage) << stage.error();
        stage_ = std::move(*stage);
    }

    static Side side(const std::string& method, const renderer::methods::Dials& given) {
        return {method, *renderer::methods::complete_for(method, given)};
    }

    /// What the probe's picture of the method says, light from behind.
    ThicknessSeen measured(const Side& wanted) {
        const auto method = stage_->method(wanted);
        EXPECT_TRUE(method) << method.error();
        auto scene = seen(initial_state(exhibit_), exhibit_, stage_->sphere(), 1);
        scene.material = thickness_probe(reach);
        scene.ambient = {0, 0, 0};
        const auto target = gpu::Target::create(size, size);
        EXPECT_TRUE((*method)->update(scene));
        target->clear();
        const auto drawing = target->draw_into();
        (*method)->draw(scene);
        std::vector<float> rgba;
        target->read(rgba);
        return thickness_seen(rgba, reach);
    }

    renderer::Expected<gpu::Context> context_ = gpu::Context::surfaceless();
    Exhibit exhibit_ = tests::exhibit_of_body("rounded-box");
    std::unique_ptr<Stage> stage_;
    int told_ = 0;
};

TEST_F(StageTest, KeepsAMethodThatWasMade) {
    const auto phong = side("phong", {}), constant = side("constant", {});
    const auto first = stage_->method(phong);
    ASSERT_TRUE(first) << first.error();
    ASSERT_TRUE(stage_->method(constant));
    EXPECT_EQ(*stage_->method(phong), *first);
    EXPECT_NE(*stage_->method(constant), *first);
}

TEST_F(StageTest, SaysWhyAMethodCannotBeMadeAndGoesOn) {
    const Side impossible{"shss", {{"bands", std::int64_t{5}}, {"directions", std::int64_t{3}}}};
    const auto method = stage_->method(impossible);
    ASSERT_FALSE(method);
    EXPECT_THAT(method.error(), testing::HasSubstr("'directions' is 3"));
    EXPECT_TRUE(stage_->method(side("phong", {})));
    EXPECT_EQ(stage_->method(impossible).error(), method.error());
}

// Exact: the method takes 12 mm everywhere, whatever the light.
TEST_F(StageTest, ReadsAConstantThicknessAsItIs) {
    const auto seen = measured(side("constant", {{"thickness_mm", 12.0}}));
    EXPECT_GT(seen.pixels, 100U);
    EXPECT_EQ(seen.known, seen.pixels);
    EXPECT_NEAR(seen.mean, 12, 0.01); // 100 mm of a rasteriser's exp, 5e-5 twice
    EXPECT_NEAR(seen.most, 12, 0.01);
}

TEST_F(StageTest, FindsNoThicknessInPhong) {
    const auto seen = measured(side("phong", {}));
    EXPECT_GT(seen.pixels, 100U);
    EXPECT_FALSE(has_thickness(seen));
}

// Green's thickness is at most the way through the body's bounding sphere, 100 mm, and the box is
// seen on the side that the light does not reach.
TEST_F(StageTest, ReadsGreensThickness) {
    ASSERT_TRUE(has_physical_law("green"));
    const auto seen = measured(side("green", {{"law", "physical"}}));
    EXPECT_TRUE(has_thickness(seen));
    EXPECT_GT(seen.mean, 5);
    EXPECT_LE(seen.most, 100);
}

TEST_F(StageTest, WorkCanBeEndedByThrowingAndAskedForAgain) {
    struct Enough {};

    auto stage = Stage::open(exhibit_, exhibit_.pieces[0], [&](double) {
        if (++told_ == 1)
            throw Enough{};
    });
    ASSERT_TRUE(stage) << stage.error();
    const auto shss = side("shss", {{"bands", std::int64_t{2}}, {"directions", std::int64_t{64}}});
    EXPECT_THROW((void)(*stage)->method(shss), Enough);
    const auto again = (*stage)->method(shss);
    EXPECT_TRUE(again) << again.error();
}

} // namespace
