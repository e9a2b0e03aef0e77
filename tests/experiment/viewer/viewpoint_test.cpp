#include "experiment/staging.h"
#include "experiment/viewer/viewpoint.h"
#include "renderer/geometry/bodies.h"
#include "tests/experiment/viewer/small_exhibit.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace {

using namespace experiment::viewer;

class Viewpoint : public testing::Test {
  protected:
    renderer::Scene scene() const { return seen(state, exhibit, sphere, 1.5); }

    glm::dvec3 to_light() const {
        return std::get<renderer::DirectionalLight>(scene().lights.front().place).to_light;
    }

    Exhibit exhibit = tests::exhibit_of_body("sphere");
    ViewerState state = initial_state(exhibit);
    renderer::geometry::BoundingSphere sphere{{1, 2, 3}, 4};
};

TEST_F(Viewpoint, AtHomeIsTheStudysOwn) {
    const auto staged = experiment::staged(exhibit.pieces[0].scene, sphere, 1.5);
    EXPECT_EQ(scene().placement, staged.placement);
    for (int column = 0; column < 4; ++column) {
        // One product with a rotation by nothing.
        EXPECT_LE(glm::distance(scene().camera.view_from_world[column],
                                staged.camera.view_from_world[column]),
                  1e-12);
        EXPECT_EQ(scene().camera.clip_from_view[column], staged.camera.clip_from_view[column]);
    }
}

TEST_F(Viewpoint, WalkingMovesTheEyeAndNothingElse) {
    const auto before = scene();
    const auto light = to_light();
    state = reduce(state, WalkEye{90, 0}, exhibit);
    EXPECT_EQ(scene().placement, before.placement);
    EXPECT_EQ(to_light(), light);
    const auto eye = glm::inverse(scene().camera.view_from_world)[3];
    EXPECT_GT(eye.x, 100); // it stood on +z
    EXPECT_NEAR(eye.z, 0, 1e-9);
}

TEST_F(Viewpoint, TurningTheLightTurnsIt) {
    const auto light = to_light();
    state = reduce(state, TurnLight{90, 0}, exhibit);
    EXPECT_NEAR(to_light().x, light.z, 1e-12);
    EXPECT_NEAR(to_light().y, light.y, 1e-12);
    EXPECT_NEAR(to_light().z, -light.x, 1e-12);
}

TEST_F(Viewpoint, ZoomMagnifiesThePicture) {
    const auto on_screen = [&](glm::dvec3 point) {
        const auto clip =
            scene().camera.clip_from_view * scene().camera.view_from_world * glm::dvec4(point, 1);
        return glm::dvec2(clip) / clip.w;
    };
    const auto before = on_screen({10, 5, 20});
    state = reduce(state, Zoom{2}, exhibit);
    EXPECT_NEAR(on_screen({10, 5, 20}).x, 2 * before.x, 1e-12);
    EXPECT_NEAR(on_screen({10, 5, 20}).y, 2 * before.y, 1e-12);
}

} // namespace
