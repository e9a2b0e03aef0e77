#include "renderer/geometry/bodies.h"
#include "renderer/methods/barre_brisebois.h"
#include "renderer/methods/catalogue.h"
#include "tests/renderer/methods/known_worlds.h"

#include <algorithm>

namespace {

using namespace known_worlds;
using methods::BarreBriseboisSettings;
using shading::Law;

class BarreBrisebois : public MethodTest {
  protected:
    static constexpr int size = 33;
    geometry::Mesh sphere = geometry::sphere(1, 5);
    thickness::ThicknessField field = sphere_field(sphere, 1, 5);

    Expected<std::unique_ptr<methods::Method>> made(const BarreBriseboisSettings& settings) {
        return methods::prepare_barre_brisebois(settings, *shading::Surface::upload(sphere), sphere,
                                                field, diameter.value / 2);
    }

    imaging::LinearImage drawn(const BarreBriseboisSettings& settings, const Scene& scene) {
        auto method = made(settings);
        EXPECT_TRUE(method) << method.error();
        auto image = pictures::render_picture(**method, scene, size, size, 1);
        EXPECT_TRUE(image) << image.error();
        return *image;
    }
};

// The formula in double, at every third pixel; the sphere's local thickness is 4/3 of its radius.
TEST_F(BarreBrisebois, IsItsLobeTimesTheLawOfTheLocalThickness) {
    const BarreBriseboisSettings settings{
        .distortion = 0.3, .power = 3, .scale = 0.8, .ambient = 0.15, .law = Law::Paper};
    for (const auto& to_light : {glm::dvec3(0, 0, -1), glm::dvec3(1, 0.5, -1)}) {
        auto scene = scene_of(sphere, to_light);
        keep_scatter_only(scene);
        const auto image = drawn(settings, scene);
        const auto L = glm::normalize(to_light);
        int checked = 0;
        for (int row = 0; row < size; row += 3)
            for (int column = 0; column < size; column += 3) {
                const auto hit = seen_by_pixel(sphere, scene, column, row, size, size);
                if (!hit)
                    continue;
                const auto N = glm::normalize(hit->point),
                           V = glm::normalize(hit->eye - hit->point);
                const double along =
                    std::clamp(glm::dot(V, -(L + N * settings.distortion)), 0.0, 1.0);
                const double passed = 1 - (4.0 / 3) / 2;
                // Thickness to 0.0026 of the radius (LocalThickness), half of it under D_n = 2,
                // times a lobe below 1; interpolated normals and floats are below that.
                EXPECT_NEAR(pixel(image, column, row).g,
                            (std::pow(along, settings.power) * settings.scale + settings.ambient) *
                                passed,
                            2e-3)
                    << column << ' ' << row;
                ++checked;
            }
        EXPECT_GT(checked, 60);
    }
}

// What the method cannot know: without the lobe, the light's direction changes nothing, not even on
// the lit side.
TEST_F(BarreBrisebois, HasTheSameThicknessWhereverTheLightStands) {
    const BarreBriseboisSettings settings{.scale = 0, .ambient = 1};
    auto scene = scene_of(sphere, {0, 0, -1});
    keep_scatter_only(scene);
    const auto behind = drawn(settings, scene);
    for (const auto& L : {glm::dvec3(0, 0, 1), glm::dvec3(-1, 0, 0)}) {
        scene.lights = {{DirectionalLight{L}, {1, 1, 1}}};
        EXPECT_EQ(drawn(settings, scene).pixels, behind.pixels);
    }
    // exp(-sigma_tr 4R/3), R = 50 mm: sigma_tr g is 0.18, and 0.2 % of 66 mm is 2.4 % of that.
    const double expected =
        std::exp(-effective_transport(scene.material.medium).g * 4.0 / 3 * diameter.value / 2);
    EXPECT_NEAR(pixel(behind, size / 2, size / 2).g, expected, 0.03 * expected);
}

// The lobe follows the eye: right before the light it is at its height, aside it is gone.
TEST_F(BarreBrisebois, ShinesOnlyBeforeTheLight) {
    const BarreBriseboisSettings settings{.distortion = 0, .ambient = 0, .law = Law::Paper};
    auto scene = scene_of(sphere, {0, 0, -1});
    keep_scatter_only(scene);
    EXPECT_NEAR(pixel(drawn(settings, scene), size / 2, size / 2).g, 0.9 / 3, 2e-3);
    for (const auto& L : {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1)}) {
        scene.lights = {{DirectionalLight{L}, {1, 1, 1}}};
        EXPECT_NEAR(pixel(drawn(settings, scene), size / 2, size / 2).g, 0, 1e-6);
    }
}

TEST_F(BarreBrisebois, IsPhongWhereNothingScatters) {
    auto scene = scene_of(sphere, {1, 1, -1});
    scene.lights.push_back({PointLight{{60, 60, 60}}, {1, 1, 1}});
    scene.material.reflectance.scatter = {0, 0, 0};
    const auto phong = picture(sphere, PhongSettings{}, scene, size);
    const auto image = drawn({}, scene);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_NEAR(image.pixels[i].g, phong.pixels[i].g, 1e-6F) << i; // another program's rounding
    EXPECT_EQ(image.coverage, phong.coverage);
}

TEST_F(BarreBrisebois, CostsOneNumberAVertex) {
    const auto method = made({});
    ASSERT_TRUE(method) << method.error();
    EXPECT_EQ((*method)->cost().bytes_per_vertex, 4U);
    EXPECT_EQ((*method)->cost().passes_per_light, 0);
}

TEST_F(BarreBrisebois, SaysWhatItCannotPrepare) {
    field.coefficients.pop_back();
    const auto method = made({});
    ASSERT_FALSE(method);
    EXPECT_THAT(method.error(), testing::HasSubstr("expected 256050 for 10242 vertices"));
    const auto dials = methods::complete_for("barre-brisebois", {{"power", 0.5}});
    ASSERT_FALSE(dials);
    EXPECT_EQ(dials.error().what, "is 0.5, expected a number from 1 to 64");
}

} // namespace
