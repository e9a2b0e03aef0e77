#include "renderer/geometry/bodies.h"
#include "renderer/methods/shss.h"
#include "renderer/pictures/choice_change.h"
#include "renderer/thickness/surface_sample.h"
#include "renderer/thickness/thickness_field.h"
#include "tests/renderer/methods/known_worlds.h"

namespace {

using namespace known_worlds;
using reconstruction::BandChooser;
using shading::Law;

class ChoiceChange : public MethodTest {
  protected:
    std::unique_ptr<methods::Method> choosing(Law law, double tolerance) {
        auto method = methods::prepare_shss(
            {.bands = {.chooser = BandChooser::Tolerance, .tolerance = tolerance}, .law = law},
            *shading::Surface::upload(torus_), field_, thickness::sample_surface(torus_, *field_));
        EXPECT_TRUE(method) << method.error();
        return std::move(*method);
    }

    geometry::Mesh torus_ = geometry::torus(2, 1, 96, 48);
    std::shared_ptr<const thickness::ThicknessField> field_ =
        std::make_shared<const thickness::ThicknessField>(
            *thickness::compute_thickness_field(torus_, {.directions = 256}));
};

// The torus hides a part of itself, and its picture has 5000 pixels where the sample has 2304
// vertices: a fifth covers both.
TEST_F(ChoiceChange, IsReckonedBeforehandWithinAFifth) {
    int checked = 0;
    for (const auto law : {Law::Paper, Law::Physical})
        for (const auto& to_light :
             {glm::dvec3(0, 0.3, -1), glm::dvec3(0.3, 0.3, 1), glm::dvec3(-1, 0.2, 0.2)})
            for (const double tolerance : {0.3, 0.03, 0.01}) {
                const auto scene = scene_of(torus_, glm::normalize(to_light), {.turn_degrees = 40});
                const auto method = choosing(law, tolerance);
                const auto image = pictures::render_picture(*method, scene, 96, 96, 4);
                ASSERT_TRUE(image);
                const auto reckoned = method->predicted_change();
                const auto measured = pictures::measured_change(*method, scene, *image, 4);
                ASSERT_TRUE(reckoned && measured && *measured);
                EXPECT_LE(*reckoned, tolerance);
                EXPECT_LE(std::abs(*reckoned - **measured), 0.2 * **measured)
                    << method->decision() << ", measured " << **measured;
                ++checked;
            }
    EXPECT_EQ(checked, 18);
}

TEST_F(ChoiceChange, LeavesTheMethodChoosing) {
    const auto scene = scene_of(torus_, {0, 0, -1});
    const auto method = choosing(Law::Physical, 1);
    const auto image = pictures::render_picture(*method, scene, 32, 32, 1);
    const auto before = method->decision();
    ASSERT_TRUE(pictures::measured_change(*method, scene, *image, 1));
    ASSERT_TRUE(method->update(scene));
    EXPECT_EQ(method->decision(), before);
}

TEST_F(ChoiceChange, IsNothingWithoutAChoice) {
    const auto scene = scene_of(torus_, {0, 0, -1});
    const auto method = prepare(torus_, methods::ShssSettings{}, field_.get());
    const auto image = pictures::render_picture(*method, scene, 32, 32, 1);
    const auto measured = pictures::measured_change(*method, scene, *image, 1);
    ASSERT_TRUE(measured);
    EXPECT_FALSE(*measured);
}

} // namespace
