#include "renderer/geometry/bodies.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/gpu/target.h"
#include "renderer/imaging/colour.h"
#include "renderer/materials.h"
#include "renderer/methods/shss.h"
#include "tests/renderer/methods/known_worlds.h"

#include <glm/ext/matrix_transform.hpp>

#include <map>

namespace {

using namespace known_worlds;
using methods::ShssSettings;
using shading::Law;
using thickness::ComponentType;

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
        const auto used = static_cast<std::size_t>(settings.bands.bands * settings.bands.bands);
        const auto stored = thickness::coefficients_of(
            thickness::band_streams(field, settings.bands.bands, settings.coefficients));
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
                        d += weight * y[i] * static_cast<double>(stored[vertex * used + i]);
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
            expect_equation(sphere, field, {.bands = {.bands = bands}, .law = law},
                            scene_of(sphere, {0.3, 0.2, -0.9}));
        }
}

// What is stored is drawn to the digits of float: 642 vertices have three blocks of bytes.
TEST_F(Shss, DrawsEquation3OfTheStoredCoefficients) {
    const auto sphere = geometry::sphere(2, 3);
    auto field = sphere_field(sphere, 2, 6);
    for (std::size_t i = 0; i < field.coefficients.size(); ++i)
        field.coefficients[i] += 0.02F * static_cast<float>(i % 36);
    for (int bands = 1; bands <= 6; ++bands)
        for (const auto type : {ComponentType::Float16, ComponentType::Int8}) {
            SCOPED_TRACE(testing::Message() << bands << " bands as " << static_cast<int>(type));
            expect_equation(sphere, field,
                            {.bands = {.bands = bands}, .law = Law::Paper, .coefficients = type},
                            scene_of(sphere, {0.3, 0.2, -0.9}));
        }
}

// The sphere hides a wrong axis in bands 3 and 5, where it has no energy: give every band some.
TEST_F(Shss, DrawsAll36Coefficients) {
    const auto sphere = geometry::sphere(2, 3);
    auto field = sphere_field(sphere, 2, 6);
    for (std::size_t i = 0; i < field.coefficients.size(); ++i)
        field.coefficients[i] += 0.02F * static_cast<float>(i % 36);
    expect_equation(sphere, field, {.bands = {.bands = 6}, .law = Law::Paper},
                    scene_of(sphere, {0.3, -0.5, -0.7}, {.turn_degrees = 50}));
}

TEST_F(Shss, TakesTheLightIntoATurnedModel) {
    const auto body = geometry::sphere(2, 3);
    auto field = sphere_field(body, 2, 5);
    for (std::size_t i = 0; i < field.coefficients.size(); ++i)
        field.coefficients[i] += 0.02F * static_cast<float>(i % 25);
    expect_equation(body, field, {.bands = {.bands = 5}, .law = Law::Paper},
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
        expect_equation(sphere, field, {.bands = {.bands = 5}, .law = law}, scene);
    }
}

TEST_F(Shss, ReconstructsTheSpheresDiameterOppositeTheLight) {
    const auto sphere = geometry::sphere(1, 5);
    const auto field = sphere_field(sphere, 1, 5);
    auto scene = scene_of(sphere, {0, 0, -1});
    keep_scatter_only(scene);
    const ShssSettings settings{.bands = {.bands = 5}, .law = Law::Paper};
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
            picture(sphere, ShssSettings{.bands = {.bands = 2}, .law = law}, scene, 33, 1, &field);
        EXPECT_EQ(pixel(image, 16, 16).g, 1.0F);
    }
}

TEST_F(Shss, WithoutAbsorptionEverythingGlowsFully) {
    const auto sphere = geometry::sphere(1, 4);
    const auto field = sphere_field(sphere, 1, 5);
    auto scene = scene_of(sphere, {0, 0, -1});
    keep_scatter_only(scene);
    scene.material.medium.sigma_a = {0, 0, 0};
    const auto image = picture(sphere, ShssSettings{.bands = {.bands = 5}}, scene, 33, 1, &field);
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
    const auto image = picture(sphere, ShssSettings{.bands = {.bands = 5}}, scene, 33, 1, &field);
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
    const std::map<ComponentType, std::size_t> bytes{
        {ComponentType::Float32, 4}, {ComponentType::Float16, 2}, {ComponentType::Int8, 1}};
    const std::size_t slots[] = {1, 1, 3, 5, 8, 11};
    for (const auto& [type, each] : bytes)
        for (std::size_t bands = 1; bands <= 6; ++bands) {
            const auto method = prepare(
                sphere,
                ShssSettings{.bands = {.bands = static_cast<int>(bands)}, .coefficients = type},
                &field);
            ASSERT_TRUE(method->update(scene_of(sphere, {0, 0, 1})));
            // and 16 bytes of ranges for each four components of the two blocks of bytes
            const std::size_t ranges = type == ComponentType::Int8 ? 2 * 16 * slots[bands - 1] : 0;
            EXPECT_EQ(method->cost().bytes_per_vertex,
                      std::lround(static_cast<double>(bands * bands * each) +
                                  static_cast<double>(ranges) / 162));
        }
}

/// Traced, not made up: a body whose thickness has energy in every band.
class ShssOnATorus : public Shss {
  protected:
    const geometry::Mesh torus_ = geometry::torus(1, 0.4, 48, 24);
    const thickness::ThicknessField field_ =
        *thickness::compute_thickness_field(torus_, {.directions = 512});

    Scene lit_from_behind() const {
        return scene_of(torus_, {0.2, 0.3, -0.9}, {.turn_degrees = 20, .elevation_degrees = 35});
    }

    /// Root mean square difference of scattered light over the pixels of the body.
    static double rms(const imaging::LinearImage& a, const imaging::LinearImage& b) {
        double sum = 0;
        int pixels = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i)
            if (a.coverage[i] == 1) {
                const double apart = static_cast<double>(a.pixels[i].g - b.pixels[i].g);
                sum += apart * apart;
                ++pixels;
            }
        EXPECT_GT(pixels, 500);
        return std::sqrt(sum / pixels);
    }
};

// 100 mm of marble, in the order in which models are loaded; scanned models: storage_bench.
TEST_F(ShssOnATorus, InBytesStaysBelowACodeValueOfTheDisplay) {
    const auto torus = geometry::along_morton_curve(geometry::torus(1, 0.4, 96, 48));
    const auto field = *thickness::compute_thickness_field(torus, {.directions = 256});
    for (const auto law : {Law::Paper, Law::Physical})
        for (const double z : {-0.9, 0.9}) {
            auto scene = scene_of(torus, {0.2, 0.3, z}, {.elevation_degrees = 35});
            scene.material = *measured_material("marble");
            const auto draw = [&](ComponentType type) {
                return picture(torus, ShssSettings{.law = law, .coefficients = type}, scene, 128, 4,
                               &field);
            };
            const auto exact = draw(ComponentType::Float32);
            for (const auto type : {ComponentType::Float16, ComponentType::Int8}) {
                const auto stored = draw(type);
                int body = 0, off = 0;
                for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
                    if (exact.coverage[i] < 1)
                        continue;
                    ++body;
                    const auto a = imaging::encode(exact.pixels[i]),
                               b = imaging::encode(stored.pixels[i]);
                    const float apart =
                        std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
                    off += apart < 1.0F / 255 ? 0 : 1;
                }
                EXPECT_GT(body, 3000);
                EXPECT_LE(off, body / 1000) << static_cast<int>(type) << " z " << z;
            }
        }
}

// The prediction is exact for the paper's law over the surface; the picture weighs the surface by
// its slope and clamps some of it, which moves the figure by less than a half.
TEST_F(ShssOnATorus, PredictsWhatTheBandsLeftOutWouldChange) {
    auto scene = lit_from_behind();
    keep_scatter_only(scene);
    const auto whole = picture(torus_, ShssSettings{.law = Law::Paper}, scene, 96, 4, &field_);
    int checked = 0;
    for (const double tolerance : {0.1, 0.05, 0.02, 0.01, 0.0001}) {
        const ShssSettings settings{
            .bands = {.chooser = reconstruction::BandChooser::Tolerance, .tolerance = tolerance},
            .law = Law::Paper};
        const auto method = prepare(torus_, settings, &field_);
        const auto image = pictures::render_picture(*method, scene, 96, 96, 4);
        ASSERT_TRUE(image);
        EXPECT_LE(rms(whole, *image), 1.5 * tolerance) << method->decision();
        EXPECT_THAT(method->decision(), testing::HasSubstr("5 bands: ")) << tolerance;
        ++checked;
    }
    EXPECT_EQ(checked, 5);
}

TEST_F(ShssOnATorus, WithAToleranceTakesAsFewBandsAsWillDo) {
    const auto bytes = [&](double tolerance) {
        const auto method =
            prepare(torus_,
                    ShssSettings{.bands = {.chooser = reconstruction::BandChooser::Tolerance,
                                           .tolerance = tolerance}},
                    &field_);
        EXPECT_TRUE(method->update(lit_from_behind()));
        return method->cost().bytes_per_vertex;
    };
    EXPECT_EQ(bytes(0), 100U); // all of them
    EXPECT_EQ(bytes(10), 16U); // the mean alone would do; the first stream holds two bands
    EXPECT_LE(bytes(0.02), bytes(0.004));
}

TEST_F(ShssOnATorus, FollowsThePapersPresetFromBehindToTheFront) {
    const auto method = prepare(
        torus_, ShssSettings{.bands = {.chooser = reconstruction::BandChooser::Paper}}, &field_);
    ASSERT_TRUE(method->update(scene_of(torus_, {0, 0, 1})));
    EXPECT_EQ(method->cost().bytes_per_vertex, 16U);
    ASSERT_TRUE(method->update(scene_of(torus_, {0, 0, -1})));
    EXPECT_EQ(method->cost().bytes_per_vertex, 100U);
}

// 150 ms from 2 to 5 bands: under the paper's law, which is straight, no pixel changes by more than
// a fifteenth of its way between two pictures 10 ms apart; a tenth more where a part of the way is
// beyond what the law clamps.
TEST_F(ShssOnATorus, FadesBandsInWithoutAJump) {
    const ShssSettings settings{.bands = {.chooser = reconstruction::BandChooser::Paper},
                                .law = Law::Paper};
    const auto method = prepare(torus_, settings, &field_);
    const auto target = gpu::Target::create(64, 64);
    ASSERT_TRUE(target);
    const auto drawn = [&](const Scene& scene, double seconds) {
        EXPECT_TRUE(method->update(scene, seconds));
        std::vector<float> pixels;
        const auto drawing = target->draw_into();
        target->clear();
        method->draw(scene);
        target->read(pixels);
        return pixels;
    };
    const auto furthest = [](const std::vector<float>& a, const std::vector<float>& b) {
        float largest = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            largest = std::max(largest, std::abs(a[i] - b[i]));
        return largest;
    };
    drawn(scene_of(torus_, {0, 0.05, 1}), 0); // two bands
    const auto behind = scene_of(torus_, {0, 0.3, -1});
    auto before = drawn(behind, 0); // the light has jumped, the bands not yet
    const auto first = before;
    float largest_step = 0;
    for (int frame = 0; frame < 15; ++frame) {
        const auto now = drawn(behind, 0.010);
        largest_step = std::max(largest_step, furthest(before, now));
        before = now;
    }
    const auto settled = drawn(behind, 1);
    EXPECT_LE(furthest(before, settled), 1e-4);
    EXPECT_GT(furthest(first, settled), 0.02); // there was something to fade
    EXPECT_LE(largest_step, 1.1F * furthest(first, settled) / 15);
}

TEST_F(Shss, SaysWhatIsWrongWithAField) {
    const auto sphere = geometry::sphere(1, 2);
    const auto field = sphere_field(sphere, 1, 3);
    const auto surface = *shading::Surface::upload(sphere);
    const auto error = [&](const ShssSettings& settings, const thickness::ThicknessField* f) {
        const auto method = make(settings, surface, f);
        return method ? std::string("no error") : method.error();
    };
    EXPECT_EQ(error({.bands = {.bands = 4}}, &field),
              "SHSS with 4 bands and a thickness field of 3, expected 4 or more");
    EXPECT_EQ(error({.bands = {.bands = 0}}, &field), "SHSS with 0 bands, expected 1..6");
    EXPECT_EQ(error({.bands = {.bands = 7}}, &field), "SHSS with 7 bands, expected 1..6");
    EXPECT_EQ(error({.bands = {.bands = 3}}, nullptr),
              "SHSS without a thickness field, expected one of its mesh");
    const auto of_another_mesh = sphere_field(geometry::sphere(1, 1), 1, 3);
    EXPECT_EQ(error({.bands = {.bands = 3}}, &of_another_mesh),
              "a thickness field of 378 coefficients, expected 1458 for 162 vertices");
    auto unscaled = field;
    unscaled.d_n = 0;
    EXPECT_EQ(error({.bands = {.bands = 3}, .law = Law::Paper}, &unscaled),
              "the thickness field's D_n is 0, expected > 0");
}

} // namespace
