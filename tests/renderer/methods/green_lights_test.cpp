// Green's methods under near lights and under several.
#include "renderer/geometry/bodies.h"
#include "tests/renderer/methods/known_worlds.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

using namespace known_worlds;
using methods::BlurredMap;
using methods::GreenSettings;
using methods::NearestMap;
using methods::PeeledMap;
using shading::Law;

using Variety = decltype(GreenSettings::map);

class GreenUnderLights : public MethodTest {
  protected:
    static constexpr int size = 65;
};

Scene near_scene(const geometry::Mesh& mesh, glm::dvec3 position) {
    auto scene = scene_of(mesh, {0, 0, 1});
    scene.lights = {{PointLight{position}, {1, 1, 1}}};
    return scene;
}

/// The scatter term of a near light also falls with the square of the distance: what is left over
/// intensity is 1 - d/D_n.
double thickness_under(const Scene& scene, glm::dvec3 point, float value) {
    const auto& light = std::get<PointLight>(scene.lights.front().place);
    const double distance = glm::distance(light.position, point) / light.reference.value;
    return diameter.value * (1 - static_cast<double>(value) * distance * distance);
}

// A near light behind a sphere: chords toward it.  From p on the sphere toward unit L the chord is
// -2 p.L.
TEST_F(GreenUnderLights, SeesChordsTowardANearLight) {
    const auto sphere = geometry::sphere(1, 6);
    auto scene = near_scene(sphere, {30, 0, -120});
    const double R = diameter.value / 2;
    keep_scatter_only(scene);
    thickness::ThicknessField field;
    field.d_n = 2;
    for (const Variety& map : {Variety(NearestMap{}), Variety(PeeledMap{2})}) {
        const auto image =
            picture(sphere, GreenSettings{.depth_map = 2048, .law = Law::Paper, .map = map}, scene,
                    size, 1, &field);
        int checked = 0;
        for (int row = 0; row < size; row += 4)
            for (int column = 0; column < size; column += 4) {
                const auto hit = seen_by_pixel(sphere, scene, column, row, size, size);
                if (!hit)
                    continue;
                const auto way =
                    std::get<PointLight>(scene.lights.front().place).position - hit->point;
                const double cosine = -glm::dot(glm::normalize(hit->point), glm::normalize(way));
                if (std::abs(cosine) < 0.5)
                    continue; // the slope runs away at the silhouette
                // A texel of the cube's 1024 is up to 2 * 170 mm / 1024 wide, 0.33 mm, and the
                // slope at most tan 60: bias and a texel's diagonal, and the mesh.
                const double tolerance = (1 + 0.71) * 0.33 * std::sqrt(3) + 6e-4 * R;
                EXPECT_NEAR(thickness_under(scene, hit->point, pixel(image, column, row).g),
                            2 * R * std::max(cosine, 0.0), tolerance)
                    << column << ' ' << row;
                ++checked;
            }
        EXPECT_GT(checked, 60);
    }
}

// Row "light inside the bounding sphere": in the hole of a ring it sees the tube all around, in
// every face of its cube; depths are never negative, and the equator is one tube thick.
TEST_F(GreenUnderLights, StandsALightWithinTheBoundingSphere) {
    const auto ring = geometry::torus(1, 0.4, 96, 48);
    const double mm = diameter.value / (2 * geometry::bounding_sphere(ring).radius);
    auto scene = near_scene(ring, {0, 0, 0});
    keep_scatter_only(scene);
    thickness::ThicknessField field;
    field.d_n = 2 * geometry::bounding_sphere(ring).radius;
    const auto image =
        picture(ring, GreenSettings{.depth_map = 2048, .law = Law::Paper}, scene, size, 1, &field);
    int checked = 0;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const auto hit = seen_by_pixel(ring, scene, column, row, size, size);
            if (!hit)
                continue;
            const double d = thickness_under(scene, hit->point, pixel(image, column, row).g);
            EXPECT_GE(d, -1e-4) << column << ' ' << row; // floats of 100 mm
            // From the hole's centre the way to the tube's far side leads through its middle where
            // the latitude is 0; here it leads through at latitude asin(z/|p|).
            const double r = glm::length(hit->point), sine = hit->point.z / r, tube = 0.4 * mm,
                         line = mm * std::sqrt(1 - sine * sine);
            const double half = std::sqrt(std::max(tube * tube - (mm * sine) * (mm * sine), 0.0));
            if (half < 0.5 * tube)
                continue; // the slope runs away where the way grazes the tube
            const double way = r > line ? 2 * half : 0.0;
            // A texel is 2 * 71 mm / 1024 = 0.14 mm, its slope at most tan 60; the mesh lies 2e-3
            // of the ring's radius inside.
            EXPECT_NEAR(d, way, 1.71 * 0.14 * std::sqrt(3) + 8e-3 * mm) << column << ' ' << row;
            ++checked;
        }
    EXPECT_GT(checked, 300);
}

// A light in the material: nothing lies before the first surface for a depth map, but the way to it
// does when surfaces know their sides.
TEST_F(GreenUnderLights, KnowsALightInTheMaterialWhenPeeled) {
    const auto sphere = geometry::sphere(1, 5);
    auto scene = near_scene(sphere, {0, 0, 0});
    keep_scatter_only(scene);
    thickness::ThicknessField field;
    field.d_n = 2;
    const auto at_centre_under = [&](const Variety& map) {
        const auto image =
            picture(sphere, GreenSettings{.depth_map = 512, .law = Law::Paper, .map = map}, scene,
                    size, 1, &field);
        return thickness_under(scene, {0, 0, diameter.value / 2},
                               pixel(image, size / 2, size / 2).g);
    };
    // A facet tilts by 0.02 against its sphere: over half a texel's diagonal, 0.28 mm.
    EXPECT_NEAR(at_centre_under(NearestMap{}), 0, 0.01);
    EXPECT_NEAR(at_centre_under(PeeledMap{2}), diameter.value / 2, 0.1);
}

// Light from two sides and from near, each with its own map: the sum of the pictures under one.
TEST_F(GreenUnderLights, AddsUpItsLights) {
    const auto ring = geometry::torus(1, 0.4, 48, 24);
    auto scene = scene_of(ring, {0, 0, -1});
    scene.ambient = {};
    const std::vector<Light> lights{{DirectionalLight{{0, 0, -1}}, {1, 1, 1}},
                                    {DirectionalLight{{-1, 0.2, 0}}, {0.5F, 0.6F, 0.7F}},
                                    {PointLight{{10, 80, -40}}, {0.3F, 0.2F, 0.1F}}};
    for (const Variety& map : {Variety(NearestMap{}), Variety(PeeledMap{4})}) {
        const GreenSettings settings{.depth_map = 256, .map = map};
        scene.lights = lights;
        const auto all = picture(ring, settings, scene, size);
        std::vector<imaging::LinearImage> alone;
        for (const auto& light : lights) {
            scene.lights = {light};
            alone.push_back(picture(ring, settings, scene, size));
        }
        for (std::size_t i = 0; i < all.pixels.size(); ++i) {
            float sum = 0;
            for (const auto& image : alone)
                sum += image.pixels[i].g;
            EXPECT_NEAR(all.pixels[i].g, sum, 1e-5F) << i; // sums of floats below 2
        }
    }
}

TEST_F(GreenUnderLights, IsNotBlurredUnderANearLight) {
    const auto blurred = prepare(geometry::sphere(1, 2), GreenSettings{.map = BlurredMap{}});
    const auto near = near_scene(geometry::sphere(1, 2), {0, 0, 100});
    EXPECT_EQ(blurred->update(near).error(),
              "a blurred depth map under a point light, expected directional lights, \"green\" or "
              "\"green-peel\"");
}

} // namespace
