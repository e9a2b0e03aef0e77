#include "renderer/geometry/bodies.h"
#include "renderer/methods/shss.h"
#include "tests/renderer/methods/known_worlds.h"

#include <glm/ext/matrix_transform.hpp>

namespace {

using namespace known_worlds;
using methods::Law;
using methods::ShssSettings;

class Shss : public MethodTest {
  protected:
    static constexpr int size = 40;

    // Compares drawn pixels with Eq. 2 at the vertices, interpolated, and Eq. 3 at the pixel.
    void expect_equation(const geometry::Mesh& sphere,
                         const thickness::ThicknessField& field,
                         const ShssSettings& settings,
                         const Scene& scene) {
        const auto image = picture(sphere, settings, scene, size, 1, &field);
        const auto normals = geometry::vertex_normals(sphere);
        const glm::dmat3 A(scene.placement.world_from_model);
        const auto v = glm::inverse(A) * glm::normalize(first_to_light(scene));
        std::vector<double> y(static_cast<std::size_t>(field.bands * field.bands));
        harmonics::evaluate(field.bands, glm::normalize(v), y);
        const auto used = static_cast<std::size_t>(settings.bands * settings.bands);
        const double d_n = field.d_n * std::cbrt(glm::determinant(A));
        int checked = 0;
        for (int row = 3; row < size; row += 6)
            for (int column = 1; column < size; column += 6) {
                const auto hit = seen_by_pixel(sphere, scene, column, row, size, size);
                if (!hit)
                    continue;
                glm::dvec3 N(0);
                double d = 0;
                for (std::size_t j = 0; j < 3; ++j) {
                    const auto vertex = sphere.triangles[hit->triangle][j];
                    const double weight = hit->weights[static_cast<int>(j)];
                    N += weight * glm::normalize(glm::transpose(glm::inverse(A)) * normals[vertex]);
                    for (std::size_t i = 0; i < used; ++i)
                        d += weight * y[i] *
                             static_cast<double>(field.coefficients[vertex * y.size() + i]);
                }
                const auto expected =
                    eq3(scene, glm::normalize(N), glm::normalize(hit->eye - hit->point),
                        d / glm::length(v), settings.law, d_n);
                const auto drawn = rgb(pixel(image, column, row));
                // Float32: d of 100 mm to 1e-5 mm, a highlight's power of 32 to 3e-5, exp and pow
                // of a software renderer to 1e-5.
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(drawn[c], expected[c], 1e-4) << column << ' ' << row;
                ++checked;
            }
        EXPECT_GT(checked, 10);
    }
};

TEST_F(Shss, DrawsEquation3WithEveryNumberOfBandsUnderBothLaws) {
    const auto sphere = geometry::sphere(2, 3);
    const auto field = sphere_field(sphere, 2, 6);
    for (int bands = 1; bands <= 6; ++bands)
        for (const auto law : {Law::Paper, Law::Physical}) {
            SCOPED_TRACE(testing::Message() << bands << " bands, law " << static_cast<int>(law));
            expect_equation(sphere, field, {.bands = bands, .law = law},
                            scene_of(sphere, {0.3, 0.2, -0.9}));
        }
}

// The sphere hides a wrong axis in bands 3 and 5, where it has no energy: give every band some.
TEST_F(Shss, DrawsAll36Coefficients) {
    const auto sphere = geometry::sphere(2, 3);
    auto field = sphere_field(sphere, 2, 6);
    for (std::size_t i = 0; i < field.coefficients.size(); ++i)
        field.coefficients[i] += 0.02F * static_cast<float>(i % 36);
    expect_equation(sphere, field, {.bands = 6, .law = Law::Paper},
                    scene_of(sphere, {0.3, -0.5, -0.7}, {.turn_degrees = 50}));
}

TEST_F(Shss, TakesTheLightIntoATurnedModel) {
    const auto body = geometry::sphere(2, 3);
    auto field = sphere_field(body, 2, 5);
    for (std::size_t i = 0; i < field.coefficients.size(); ++i)
        field.coefficients[i] += 0.02F * static_cast<float>(i % 25);
    expect_equation(body, field, {.bands = 5, .law = Law::Paper},
                    scene_of(body, {-0.6, 0.3, -0.4},
                             {.turn_degrees = 130, .elevation_degrees = 25, .up = {0, 0, 1}}));
}

// An ellipsoid is a stretched sphere, and thickness stretches with it along every direction.
TEST_F(Shss, IsExactUnderAnUnevenScaling) {
    const auto sphere = geometry::sphere(2, 3);
    const auto field = sphere_field(sphere, 2, 5);
    for (const auto law : {Law::Paper, Law::Physical}) {
        auto scene = scene_of(sphere, {0.5, 0.4, -0.6});
        scene.placement.world_from_model =
            glm::scale(scene.placement.world_from_model, {1.0, 0.6, 0.8});
        expect_equation(sphere, field, {.bands = 5, .law = law}, scene);
    }
}

TEST_F(Shss, ReconstructsTheSpheresDiameterOppositeTheLight) {
    const auto sphere = geometry::sphere(1, 5);
    const auto field = sphere_field(sphere, 1, 5);
    auto scene = scene_of(sphere, {0, 0, -1});
    keep_scatter_only(scene);
    const ShssSettings settings{.bands = 5, .law = Law::Paper};
    const auto image = picture(sphere, settings, scene, 65, 1, &field);
    // Five bands give 1.9375 R for the true 2 R [methods page A6]: 1 - 1.9375/2.
    EXPECT_NEAR(pixel(image, 32, 32).g, 1 - 1.9375 / 2, 1e-4);
}

TEST_F(Shss, NegativeThicknessDoesNotBrightenPastTheScatterCoefficient) {
    const auto sphere = geometry::sphere(1, 4);
    const auto field = sphere_field(sphere, 1, 2); // down to -0.5 R on the lit side
    for (const auto law : {Law::Paper, Law::Physical}) {
        auto scene = scene_of(sphere, {0, 0, 1});
        keep_scatter_only(scene);
        const auto image =
            picture(sphere, ShssSettings{.bands = 2, .law = law}, scene, 33, 1, &field);
        EXPECT_EQ(pixel(image, 16, 16).g, 1.0F);
    }
}

TEST_F(Shss, WithoutAbsorptionEverythingGlowsFully) {
    const auto sphere = geometry::sphere(1, 4);
    const auto field = sphere_field(sphere, 1, 5);
    auto scene = scene_of(sphere, {0, 0, -1});
    keep_scatter_only(scene);
    scene.material.medium.sigma_a = {0, 0, 0};
    const auto image = picture(sphere, ShssSettings{.bands = 5}, scene, 33, 1, &field);
    int covered = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (image.coverage[i] == 1) {
            EXPECT_EQ(image.pixels[i].g, 1.0F);
            ++covered;
        }
    EXPECT_GT(covered, 500);
}

TEST_F(Shss, HugeAbsorptionLetsNothingThrough) {
    const auto sphere = geometry::sphere(1, 4);
    const auto field = sphere_field(sphere, 1, 5);
    auto scene = scene_of(sphere, {0, 0, -1});
    keep_scatter_only(scene);
    scene.material.medium.sigma_a = {1e6, 1e6, 1e6};
    const auto image = picture(sphere, ShssSettings{.bands = 5}, scene, 33, 1, &field);
    EXPECT_EQ(pixel(image, 16, 16).g, 0.0F);
}

// The same sphere in metres, in micrometres and a thousand kilometres from its origin.
TEST_F(Shss, NeitherUnitNorOriginChangesThePicture) {
    const auto sphere = geometry::sphere(1, 3);
    const auto field = sphere_field(sphere, 1, 5);
    const auto reference =
        picture(sphere, ShssSettings{}, scene_of(sphere, {0.2, 0.1, -1}), 32, 1, &field);
    const auto expect_same = [&](double scale, glm::dvec3 offset) {
        auto moved = sphere;
        for (auto& position : moved.positions)
            position = scale * position + offset;
        auto scaled = field;
        for (auto& c : scaled.coefficients)
            c *= static_cast<float>(scale);
        scaled.d_n *= scale;
        const auto image =
            picture(moved, ShssSettings{}, scene_of(moved, {0.2, 0.1, -1}), 32, 1, &scaled);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            EXPECT_NEAR(image.pixels[i].g, reference.pixels[i].g, 1e-5);
    };
    expect_same(1e-6, {0, 0, 0});
    expect_same(1e6, {0, 0, 0});
    expect_same(1, {1e6, -1e6, 1e6}); // double keeps 1e-10 there; float would keep 0.06
}

TEST_F(Shss, SendsOnlyTheBandsAskedFor) {
    const auto sphere = geometry::sphere(1, 2);
    const auto field = sphere_field(sphere, 1, 6);
    for (std::size_t bands = 1; bands <= 6; ++bands) {
        const auto method = prepare(sphere, ShssSettings{.bands = static_cast<int>(bands)}, &field);
        EXPECT_EQ(method->cost().bytes_per_vertex, bands * bands * 4);
    }
}

TEST_F(Shss, SaysWhatIsWrongWithAField) {
    const auto sphere = geometry::sphere(1, 2);
    const auto field = sphere_field(sphere, 1, 3);
    const auto surface = *methods::Surface::upload(sphere);
    const auto error = [&](const ShssSettings& settings, const thickness::ThicknessField* f) {
        const auto method = make(settings, surface, f);
        return method ? std::string("no error") : method.error();
    };
    EXPECT_EQ(error({.bands = 4}, &field),
              "SHSS with 4 bands and a thickness field of 3, expected 4 or more");
    EXPECT_EQ(error({.bands = 0}, &field), "SHSS with 0 bands, expected 1..6");
    EXPECT_EQ(error({.bands = 7}, &field), "SHSS with 7 bands, expected 1..6");
    EXPECT_EQ(error({.bands = 3}, nullptr),
              "SHSS without a thickness field, expected one of its mesh");
    const auto of_another_mesh = sphere_field(geometry::sphere(1, 1), 1, 3);
    EXPECT_EQ(error({.bands = 3}, &of_another_mesh),
              "a thickness field of 378 coefficients, expected 1458 for 162 vertices");
    auto unscaled = field;
    unscaled.d_n = 0;
    EXPECT_EQ(error({.bands = 3, .law = Law::Paper}, &unscaled),
              "the thickness field's D_n is 0, expected > 0");
}

} // namespace
