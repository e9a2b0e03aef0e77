#include "renderer/geometry/bodies.h"
#include "renderer/methods/traced.h"
#include "tests/renderer/methods/known_worlds.h"

namespace {

using namespace known_worlds;
using shading::Law;

class Traced : public MethodTest {
  protected:
    imaging::LinearImage drawn(const Scene& scene) {
        const auto method =
            methods::prepare_traced({}, *shading::Surface::upload(torus_), torus_, nullptr);
        EXPECT_TRUE(method);
        const auto image = pictures::render_picture(**method, scene, 64, 64, 1);
        EXPECT_TRUE(image);
        return *image;
    }

    geometry::Mesh torus_ = geometry::torus(2, 1, 64, 32);
};

// Where no light has to pass anything, exp(0) of the scatter coefficient is left.
TEST_F(Traced, LeavesTheLitSideBright) {
    auto scene = scene_of(torus_, {0, 0, 1});
    keep_scatter_only(scene);
    const auto image = drawn(scene);
    EXPECT_NEAR(pixel(image, 32, 52).g, 1, 1e-6); // the ridge of the ring
}

// The light's intensities add up: two lights are the sum of each alone, in floats.
TEST_F(Traced, AddsLights) {
    auto scene = scene_of(torus_, {0, 0, -1});
    keep_scatter_only(scene);
    const Light behind = scene.lights.front();
    const Light beside{DirectionalLight{{-1, 0, 0}}, {1, 1, 1}};
    const auto first = drawn(scene);
    scene.lights = {beside};
    const auto second = drawn(scene);
    scene.lights = {behind, beside};
    const auto both = drawn(scene);
    int body = 0;
    for (std::size_t i = 0; i < both.pixels.size(); ++i)
        if (both.coverage[i] == 1.0F) {
            EXPECT_NEAR(both.pixels[i].g, first.pixels[i].g + second.pixels[i].g, 1e-5);
            ++body;
        }
    EXPECT_GT(body, 500);
}

TEST_F(Traced, RefusesNearLights) {
    auto scene = scene_of(torus_, {0, 0, -1});
    scene.lights = {{PointLight{{0, 0, 200}, {100}}, {1, 1, 1}}};
    const auto method =
        methods::prepare_traced({}, *shading::Surface::upload(torus_), torus_, nullptr);
    const auto ready = (*method)->update(scene);
    ASSERT_FALSE(ready);
    EXPECT_THAT(ready.error(), testing::HasSubstr("expected directional lights"));
}

TEST_F(Traced, RefusesAMeshWithoutAnInside) {
    auto turned = torus_;
    for (auto& [a, b, c] : turned.triangles)
        std::swap(b, c);
    EXPECT_FALSE(methods::prepare_traced({}, *shading::Surface::upload(turned), turned, nullptr));
}

} // namespace
