#include "renderer/geometry/bodies.h"
#include "tests/renderer/methods/known_worlds.h"

namespace {

using namespace known_worlds;

class Phong : public MethodTest {};

// The middle of the sphere faces camera and light, N.L = 1; a sphere of 20,480 triangles has
// interpolated normals within 1e-4 there, whose cosine is 1 to 1e-8.
TEST_F(Phong, LambertFacingTheLightHasTheRadianceOfItsAlbedoTimesIntensity) {
    const auto sphere = geometry::sphere(1, 5);
    auto scene = scene_of(sphere, {0, 0, 1});
    scene.material.reflectance = {
        .ambient = {}, .diffuse = {0.5F, 0.4F, 0.3F}, .specular = {}, .scatter = {}};
    const auto centre = pixel(picture(sphere, PhongSettings{}, scene, 65), 32, 32);
    EXPECT_NEAR(centre.r, 0.5 * 0.9, 1e-6);
    EXPECT_NEAR(centre.g, 0.4 * 1.0, 1e-6);
    EXPECT_NEAR(centre.b, 0.3 * 1.1, 1e-6);
}

TEST_F(Phong, LitFromBehindOnlyTheAmbientTermIsLeft) {
    const auto sphere = geometry::sphere(1, 4);
    const auto scene = scene_of(sphere, {0, 0, -1});
    const auto centre = pixel(picture(sphere, PhongSettings{}, scene, 65), 32, 32);
    EXPECT_FLOAT_EQ(centre.r, 0.02F * 1.0F);
    EXPECT_FLOAT_EQ(centre.g, 0.03F * 0.9F);
    EXPECT_FLOAT_EQ(centre.b, 0.04F * 0.8F);
}

TEST_F(Phong, AgreesWithItsEquationInDouble) {
    constexpr int size = 48;
    const auto body = geometry::torus(1, 0.4, 48, 24);
    const auto scene =
        scene_of(body, {0.3, 0.5, 0.8}, {.turn_degrees = 20, .elevation_degrees = 35});
    auto without_scatter = scene;
    without_scatter.material.reflectance.scatter = {};
    const auto image = picture(body, PhongSettings{}, scene, size);
    const auto normals = geometry::vertex_normals(body);
    const auto normal_matrix =
        glm::transpose(glm::inverse(glm::dmat3(scene.placement.world_from_model)));
    int checked = 0;
    for (int row = 1; row < size; row += 5)
        for (int column = 2; column < size; column += 5) {
            const auto hit = seen_by_pixel(body, scene, column, row, size, size);
            if (!hit)
                continue;
            glm::dvec3 N(0);
            for (int j = 0; j < 3; ++j)
                N += hit->weights[j] *
                     glm::normalize(
                         normal_matrix *
                         normals[body.triangles[hit->triangle][static_cast<std::size_t>(j)]]);
            const auto expected =
                eq3(without_scatter, glm::normalize(N), glm::normalize(hit->eye - hit->point), 0,
                    shading::Law::Physical, 1);
            const auto drawn = rgb(pixel(image, column, row));
            // A power of 32 turns the 1e-6 of interpolated float normals into 3e-5.
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(drawn[c], expected[c], 1e-4) << column << ' ' << row;
            ++checked;
        }
    EXPECT_GT(checked, 20);
}

TEST_F(Phong, NormalisesALongLight) {
    const auto sphere = geometry::sphere(1, 3);
    const auto unit = picture(sphere, PhongSettings{}, scene_of(sphere, {0, 0.6, 0.8}), 16);
    const auto longer = picture(sphere, PhongSettings{}, scene_of(sphere, {0, 6, 8}), 16);
    for (std::size_t i = 0; i < unit.pixels.size(); ++i)
        EXPECT_NEAR(unit.pixels[i].g, longer.pixels[i].g, 1e-6); // 0.6 and 0.8 are rounded
}

TEST_F(Phong, RejectsAPlacementThatFlattensTheModel) {
    const auto sphere = geometry::sphere(1, 2);
    auto scene = scene_of(sphere, {0, 0, 1});
    scene.placement.world_from_model[1] = {0, 0, 0, 0};
    const auto image = pictures::render_picture(*prepare(sphere, PhongSettings{}), scene, 8, 8, 1);
    ASSERT_FALSE(image);
    EXPECT_THAT(image.error(), testing::HasSubstr("flattens the model"));
}

} // namespace
