#include "renderer/diffusion/dipole.h"
#include "renderer/geometry/bodies.h"
#include "renderer/methods/catalogue.h"
#include "renderer/methods/patro.h"
#include "renderer/methods/phong.h"
#include "renderer/smoothing/shading_fields.h"
#include "tests/renderer/methods/known_worlds.h"

#include <array>

namespace {

using namespace known_worlds;
using methods::PatroSettings;

constexpr PatroSettings normals{PatroSettings::Variant::Normals};
constexpr PatroSettings harmonics_variant{PatroSettings::Variant::Harmonics};
constexpr int size = 48;

class Patro : public MethodTest {
  protected:
    imaging::LinearImage
    patro(const PatroSettings& settings, const geometry::Mesh& mesh, const Scene& scene) {
        auto surface = shading::Surface::upload(mesh);
        EXPECT_TRUE(surface) << surface.error();
        auto method = methods::prepare_patro(settings, {.mesh = mesh,
                                                        .surface = *surface,
                                                        .material = scene.material,
                                                        .placement = scene.placement,
                                                        .field = {},
                                                        .progress = {}});
        EXPECT_TRUE(method) << method.error();
        const auto image = pictures::render_picture(**method, scene, size, size, 1);
        EXPECT_TRUE(image) << image.error();
        return *image;
    }

    imaging::LinearImage phong(const geometry::Mesh& mesh, const Scene& scene) {
        const auto method = methods::prepare_phong(*shading::Surface::upload(mesh));
        return *pictures::render_picture(**method, scene, size, size, 1);
    }
};

geometry::Mesh body() {
    return geometry::torus(1, 0.4, 48, 24);
}

/// Far and near, front and side.
Scene lit_twice(const geometry::Mesh& mesh) {
    auto scene = scene_of(mesh, {0.3, 0.5, 0.8}, {.turn_degrees = 20, .elevation_degrees = 35});
    scene.lights.push_back({PointLight{{-60, 20, 40}, Millimetres{70}}, {0.5F, 0.4F, 0.3F}});
    return scene;
}

Medium without_scattering() {
    return {.sigma_a = {1, 1, 1}, .sigma_s_reduced = {0, 0, 0}};
}

std::array<double, 3> diffusion_times_mm2(const Medium& medium) {
    std::array<double, 3> times{};
    const auto dipoles = diffusion::dipoles(medium);
    for (std::size_t c = 0; c < 3; ++c)
        times[c] = smoothing::diffusion_time(diffusion::mean_square_radius(dipoles[c]), diameter);
    return times;
}

double greatest_difference(const imaging::LinearImage& a, const imaging::LinearImage& b) {
    double greatest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const auto difference = glm::abs(rgb(a.pixels[i]) - rgb(b.pixels[i]));
        greatest = std::max({greatest, difference.r, difference.g, difference.b});
    }
    return greatest;
}

TEST(PatroMethod, SaysWhereverItIsNamedThatItIsAReconstruction) {
    const auto* method = methods::find_method("patro");
    ASSERT_NE(method, nullptr);
    EXPECT_THAT(method->label, testing::HasSubstr("Patro (reconstruction)"));
    EXPECT_EQ(method->source, "Patro2007");
}

// Where light does not spread at all, t = 0.
TEST_F(Patro, WithoutSpreadIsPhongBitForBit) {
    const auto mesh = body();
    auto scene = lit_twice(mesh);
    scene.material.medium = without_scattering();
    EXPECT_EQ(patro(normals, mesh, scene).pixels, phong(mesh, scene).pixels);
}

TEST_F(Patro, OfAnOpaqueMaterialIsPhong) {
    const auto mesh = body();
    auto scene = lit_twice(mesh);
    scene.material.medium = {.sigma_a = {1e6, 1e6, 1e6}, .sigma_s_reduced = {1e6, 1e6, 1e6}};
    EXPECT_LE(greatest_difference(patro(normals, mesh, scene), phong(mesh, scene)), 1e-6);
}

TEST_F(Patro, SoftensOnlyChannelsInWhichLightSpreads) {
    const auto mesh = body();
    auto scene = lit_twice(mesh);
    scene.material.medium = {.sigma_a = {0.002, 1, 1}, .sigma_s_reduced = {2, 0, 0}};
    const auto soft = patro(normals, mesh, scene), hard = phong(mesh, scene);
    double red = 0;
    for (std::size_t i = 0; i < soft.pixels.size(); ++i) {
        ASSERT_EQ(soft.pixels[i].g, hard.pixels[i].g);
        ASSERT_EQ(soft.pixels[i].b, hard.pixels[i].b);
        red = std::max(red, std::abs(static_cast<double>(soft.pixels[i].r - hard.pixels[i].r)));
    }
    EXPECT_GE(red, 0.005); // about one code value of eight bits
}

TEST_F(Patro, LeavesHighlightsAndAmbientLightToTheSurfacesOwnNormals) {
    const auto mesh = body();
    auto scene = lit_twice(mesh);
    scene.material.reflectance.diffuse = {};
    for (const auto& settings : {normals, harmonics_variant})
        EXPECT_EQ(patro(settings, mesh, scene).pixels, phong(mesh, scene).pixels);
}

TEST_F(Patro, CannotTransmitLight) {
    const auto mesh = body();
    const auto scene = lit_twice(mesh);
    auto without_scatter = scene;
    without_scatter.material.reflectance.scatter = {};
    for (const auto& settings : {normals, harmonics_variant})
        EXPECT_EQ(patro(settings, mesh, scene).pixels,
                  patro(settings, mesh, without_scatter).pixels);
}

TEST_F(Patro, OfThreeEqualLightsIsThatOfOneThreeTimesAsStrong) {
    const auto mesh = body();
    auto many = scene_of(mesh, {0.3, 0.5, 0.8});
    auto strong = many;
    many.lights = {many.lights[0], many.lights[0], many.lights[0]};
    auto& [r, g, b] = strong.lights[0].intensity;
    r *= 3, g *= 3, b *= 3;
    for (const auto& settings : {normals, harmonics_variant})
        EXPECT_LE(greatest_difference(patro(settings, mesh, many), patro(settings, mesh, strong)),
                  3e-6); // 1e-6 of the brightest
}

/// Calls `check(expected, drawn)` for some pixels of the body, the diffuse light worked out in
/// double from `diffuse_light(triangle, weights)`.
template <class DiffuseLight>
void expect_diffuse(const geometry::Mesh& mesh,
                    const Scene& scene,
                    const imaging::LinearImage& image,
                    double tolerance,
                    DiffuseLight&& diffuse_light) {
    int checked = 0;
    for (int row = 1; row < size; row += 4)
        for (int column = 2; column < size; column += 4) {
            const auto hit = seen_by_pixel(mesh, scene, column, row, size, size);
            if (!hit)
                continue;
            const auto expected =
                rgb(scene.lights[0].intensity) * rgb(scene.material.reflectance.diffuse) *
                glm::max(diffuse_light(mesh.triangles[hit->triangle], hit->weights), glm::dvec3(0));
            const auto& drawn = image.pixels[static_cast<std::size_t>(row * size + column)];
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(rgb(drawn)[c], expected[c], tolerance) << column << ' ' << row;
            ++checked;
        }
    EXPECT_GT(checked, 30);
}

/// One light, diffuse reflection only, a model turned and raised.
Scene diffuse_scene(const geometry::Mesh& mesh) {
    auto scene = scene_of(mesh, {0.3, 0.5, 0.8}, {.turn_degrees = 50, .elevation_degrees = 35});
    scene.material.reflectance.ambient = {};
    scene.material.reflectance.specular = {};
    return scene;
}

double mm_per_unit(const geometry::Mesh& mesh) {
    return diameter.value / (2 * geometry::bounding_sphere(mesh).radius);
}

TEST_F(Patro, WithNormalsAgreesWithItsEquationInDouble) {
    const auto mesh = body();
    const auto scene = diffuse_scene(mesh);
    const double scale = mm_per_unit(mesh);
    const auto own = geometry::vertex_normals(mesh);
    smoothing::SurfaceSmoother smoother(mesh);
    std::array<std::vector<glm::dvec3>, 3> smooth;
    const auto times = diffusion_times_mm2(scene.material.medium);
    for (std::size_t c = 0; c < 3; ++c)
        smooth[c] = smoothing::smoothed_normals(smoother, times[c] / (scale * scale), own).value();
    const auto L = glm::normalize(first_to_light(scene));
    const auto normal_matrix =
        glm::transpose(glm::inverse(glm::dmat3(scene.placement.world_from_model)));
    expect_diffuse(mesh, scene, patro(normals, mesh, scene), 1e-6,
                   [&](const geometry::Triangle& triangle, glm::dvec3 weights) {
                       glm::dvec3 cosines;
                       for (int c = 0; c < 3; ++c) {
                           glm::dvec3 N(0);
                           for (int j = 0; j < 3; ++j)
                               N += weights[j] *
                                    glm::normalize(normal_matrix *
                                                   smooth[static_cast<std::size_t>(c)]
                                                         [triangle[static_cast<std::size_t>(j)]]);
                           cosines[c] = glm::dot(glm::normalize(N), L);
                       }
                       return cosines;
                   });
}

TEST_F(Patro, WithHarmonicsAgreesWithItsEquationInDouble) {
    const auto mesh = body();
    const auto scene = diffuse_scene(mesh);
    const double scale = mm_per_unit(mesh);
    smoothing::SurfaceSmoother smoother(mesh);
    std::array<std::vector<double>, 3> e;
    const auto times = diffusion_times_mm2(scene.material.medium);
    for (std::size_t c = 0; c < 3; ++c)
        e[c] = smoothing::smoothed_irradiance(smoother, times[c] / (scale * scale),
                                              geometry::vertex_normals(mesh))
                   .value();
    const auto L = glm::normalize(glm::inverse(glm::dmat3(scene.placement.world_from_model)) *
                                  first_to_light(scene));
    std::array<double, 9> y{};
    harmonics::evaluate(3, L, y);
    expect_diffuse(mesh, scene, patro(harmonics_variant, mesh, scene), 1e-5,
                   [&](const geometry::Triangle& triangle, glm::dvec3 weights) {
                       glm::dvec3 irradiance(0);
                       for (int c = 0; c < 3; ++c)
                           for (int j = 0; j < 3; ++j)
                               for (std::size_t i = 0; i < 9; ++i)
                                   irradiance[c] +=
                                       weights[j] * y[i] *
                                       e[static_cast<std::size_t>(c)]
                                        [9 * triangle[static_cast<std::size_t>(j)] + i];
                       return irradiance;
                   });
}

TEST_F(Patro, KnowsMillimetresAndNoOtherUnit) {
    const auto mesh = body();
    const auto scene = diffuse_scene(mesh);
    for (const double unit : {1e-6, 1e6}) {
        auto scaled = mesh;
        for (auto& position : scaled.positions)
            position *= unit;
        const auto scaled_scene = diffuse_scene(scaled); // mm per unit make up for it
        for (const auto& settings : {normals, harmonics_variant})
            EXPECT_LE(greatest_difference(patro(settings, scaled, scaled_scene),
                                          patro(settings, mesh, scene)),
                      1e-5) // positions are rounded to float in another place
                << unit;
    }
}

TEST_F(Patro, WithoutAbsorptionIsAsSoftAsCanBeAndFinite) {
    const auto mesh = body();
    auto scene = diffuse_scene(mesh);
    scene.material.medium.sigma_a = {0, 0, 0};
    for (const auto& settings : {normals, harmonics_variant})
        for (const auto& pixel : patro(settings, mesh, scene).pixels)
            ASSERT_TRUE(std::isfinite(pixel.r) && pixel.r >= 0);
}

TEST_F(Patro, LeavesAVertexWithoutTrianglesAlone) {
    auto mesh = body();
    const auto scene = diffuse_scene(mesh);
    const auto without = patro(normals, mesh, scene);
    mesh.positions.emplace_back(0, 0, 0);
    EXPECT_LE(greatest_difference(patro(normals, mesh, scene), without), 1e-6);
}

} // namespace
