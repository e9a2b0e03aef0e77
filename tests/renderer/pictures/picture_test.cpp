#include "renderer/geometry/bodies.h"
#include "renderer/pictures/picture.h"
#include "tests/renderer/methods/known_worlds.h"

#include <cstring>
#include <set>

namespace {

using namespace known_worlds;

class RenderPicture : public MethodTest {};

TEST(SampleOffsets, FillEveryRowAndColumnOnce) {
    for (const int n : {1, 4, 16, 64}) {
        std::set<int> columns, rows;
        for (const auto& offset : pictures::sample_offsets(n)) {
            columns.insert(static_cast<int>(std::floor((offset.x + 0.5) * n)));
            rows.insert(static_cast<int>(std::floor((offset.y + 0.5) * n)));
        }
        EXPECT_EQ(columns.size(), static_cast<std::size_t>(n));
        EXPECT_EQ(rows.size(), static_cast<std::size_t>(n));
        EXPECT_EQ(*columns.begin(), 0);
        EXPECT_EQ(*rows.rbegin(), n - 1);
    }
}

TEST(SampleOffsets, OneSampleIsTheCentre) {
    EXPECT_EQ(pictures::sample_offsets(1).at(0), glm::dvec2(0, 0));
}

TEST_F(RenderPicture, HasItsTopRowFirst) {
    const auto sphere = geometry::sphere(1, 4);
    const auto image = picture(sphere, PhongSettings{}, scene_of(sphere, {0, 1, 0}), 33, 4);
    EXPECT_GT(pixel(image, 16, 5).g, 3 * pixel(image, 16, 27).g); // lit from above
}

TEST_F(RenderPicture, HasRightOnTheRight) {
    const auto sphere = geometry::sphere(1, 4);
    const auto image = picture(sphere, PhongSettings{}, scene_of(sphere, {1, 0, 0}), 33, 4);
    EXPECT_GT(pixel(image, 27, 16).g, 3 * pixel(image, 5, 16).g);
}

// The sphere's silhouette is a circle of radius 1/1.04 of half the picture.  2,500 pixels on its
// disc, 200 of them on its edge, each known to 1/16: the sum is known to 200/16/2/sqrt(200) < 1 %.
TEST_F(RenderPicture, CoverageIsTheAreaOfTheSilhouette) {
    constexpr int size = 60;
    const auto sphere = geometry::sphere(1, 5);
    const auto image = picture(sphere, PhongSettings{}, scene_of(sphere, {0, 0, 1}), size, 16);
    double area = 0;
    std::set<float> values;
    for (const float coverage : image.coverage) {
        area += static_cast<double>(coverage);
        values.insert(coverage);
    }
    const double half_angle = from_degrees(15).value;
    const double edge = std::tan(std::asin(std::sin(half_angle) / 1.04)) / std::tan(half_angle);
    EXPECT_NEAR(area / (std::numbers::pi * size * size / 4 * edge * edge), 1, 0.01);
    EXPECT_EQ(*values.begin(), 0);
    EXPECT_EQ(*values.rbegin(), 1);
    EXPECT_EQ(values.size(), 17U); // sixteenths
}

TEST_F(RenderPicture, ColoursArePremultipliedByCoverage) {
    const auto sphere = geometry::sphere(1, 4);
    auto scene = scene_of(sphere, {0, 0, 1});
    scene.material.reflectance = {
        .ambient = {0.5F, 0.5F, 0.5F}, .diffuse = {}, .specular = {}, .scatter = {}};
    scene.ambient = {1, 1, 1};
    const auto image = picture(sphere, PhongSettings{}, scene, 32, 16);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_EQ(image.pixels[i].g, 0.5F * image.coverage[i]);
}

// k's are common to all methods; without the fourth term nothing tells them apart.
TEST_F(RenderPicture, WithoutScatterAllMethodsDrawTheSameBits) {
    const auto body = geometry::torus(1, 0.4, 60, 30);
    thickness::ThicknessField field; // any will do: its light is multiplied by 0
    field.bands = 6;
    field.d_n = 1;
    field.coefficients.assign(body.positions.size() * 36, 0.1F);
    auto scene = scene_of(body, {0.5, 0.3, 0.4}, {.turn_degrees = 30, .elevation_degrees = 40});
    scene.material.reflectance.scatter = {};
    const auto phong = picture(body, PhongSettings{}, scene, 64, 4);
    const auto same_bits = [&](const auto& settings) {
        const auto image = picture(body, settings, scene, 64, 4, &field);
        return image.coverage == phong.coverage &&
               std::memcmp(image.pixels.data(), phong.pixels.data(),
                           phong.pixels.size() * sizeof(LinearRgb)) == 0;
    };
    for (const auto law : {shading::Law::Paper, shading::Law::Physical}) {
        EXPECT_TRUE(same_bits(methods::GreenSettings{.depth_map = 256, .law = law}));
        for (int bands = 1; bands <= 6; ++bands)
            EXPECT_TRUE(same_bits(methods::ShssSettings{.bands = {.bands = bands}, .law = law}))
                << bands;
    }
}

TEST_F(RenderPicture, IsTheSameBitForBitWhenDrawnAgain) {
    const auto sphere = geometry::sphere(1, 4);
    const auto field = sphere_field(sphere, 1, 5);
    const auto scene = scene_of(sphere, {0.2, 0.2, -1});
    const auto once = picture(sphere, methods::ShssSettings{}, scene, 48, 8, &field);
    const auto again = picture(sphere, methods::ShssSettings{}, scene, 48, 8, &field);
    EXPECT_EQ(once.pixels, again.pixels);
    EXPECT_EQ(once.coverage, again.coverage);
}

// A closed body drawn without culling: no pixel inside its silhouette shows the background or is
// darker than the ambient light.
TEST_F(RenderPicture, HasNeitherCracksNorBlackTriangles) {
    const auto sphere = geometry::sphere(1, 5);
    const auto scene = scene_of(sphere, {0.7, 0.2, -0.3});
    const auto field = sphere_field(sphere, 1, 5);
    const auto expect_whole = [&](const auto& settings) {
        const auto image = picture(sphere, settings, scene, 128, 16, &field);
        for (int row = 0; row < 128; ++row)
            for (int column = 0; column < 128; ++column) {
                if (std::hypot(column - 63.5, row - 63.5) > 59)
                    continue;
                EXPECT_EQ(image.coverage[static_cast<std::size_t>(row * 128 + column)], 1);
                EXPECT_GE(pixel(image, column, row).r, 0.02F * 0.999F);
            }
    };
    expect_whole(PhongSettings{});
    expect_whole(methods::GreenSettings{.depth_map = 512});
    expect_whole(methods::ShssSettings{});
}

TEST_F(RenderPicture, RejectsASizeTheDeviceCannotDraw) {
    const auto sphere = geometry::sphere(1, 2);
    const auto method = prepare(sphere, PhongSettings{});
    const auto image = pictures::render_picture(*method, scene_of(sphere, {0, 0, 1}), 0, 100, 1);
    ASSERT_FALSE(image);
    EXPECT_THAT(image.error(), testing::StartsWith("a picture of 0 x 100 texels, expected 1 to "));
}

TEST_F(RenderPicture, RejectsALightWithoutADirectionWhateverTheMethod) {
    const auto sphere = geometry::sphere(1, 2);
    const auto field = sphere_field(sphere, 1, 5);
    const auto expect_refused = [&](const auto& settings) {
        for (const auto& L : {glm::dvec3(0, 0, 0), glm::dvec3(0, NAN, 1)}) {
            const auto method = prepare(sphere, settings, &field);
            const auto image = pictures::render_picture(*method, scene_of(sphere, L), 8, 8, 1);
            ASSERT_FALSE(image);
            EXPECT_THAT(image.error(),
                        testing::MatchesRegex(
                            "light direction \\(0, .*\\), expected a vector with a length"));
        }
    };
    expect_refused(PhongSettings{});
    expect_refused(methods::GreenSettings{.depth_map = 64});
    expect_refused(methods::ShssSettings{});
}

TEST(Surface, RejectsWhatCannotBeDrawn) {
    const auto context = gpu::Context::surfaceless();
    ASSERT_TRUE(context) << context.error();
    const auto error = [](const geometry::Mesh& mesh) {
        const auto surface = shading::Surface::upload(mesh);
        return surface ? std::string("no error") : surface.error();
    };
    EXPECT_EQ(error({}), "a mesh without triangles, expected something to draw");
    EXPECT_EQ(error({.positions = {{0, 0, 0}, {1, 0, 0}}, .triangles = {{0, 1, 2}}}),
              "a triangle names vertex 2, expected 0..1");
    EXPECT_EQ(error({.positions = {{1, 1, 1}}, .triangles = {{0, 0, 0}}}),
              "a mesh of radius 0, expected a positive extent");
}

} // namespace
