#include "renderer/diffusion/diffusion_profile.h"
#include "renderer/geometry/bodies.h"
#include "renderer/gpu/target.h"
#include "renderer/methods/catalogue.h"
#include "renderer/methods/separable.h"
#include "tests/renderer/geometry/assembly.h"
#include "tests/renderer/methods/known_worlds.h"

#include <algorithm>
#include <array>

namespace {

using namespace known_worlds;
using methods::SeparableSettings;
using shading::Law;

class Separable : public MethodTest {
  protected:
    static constexpr int size = 96;

    /// Scatters over some pixels: 100 mm are 92 pixels, and d is 1.84, 1.01 and 0.29 mm.
    static Scene
    wide_scene(const geometry::Mesh& mesh, glm::dvec3 to_light, const Turntable& table = {}) {
        auto scene = scene_of(mesh, to_light, table);
        scene.material.medium = {.sigma_a = {0.001, 0.005, 0.1},
                                 .sigma_s_reduced = {0.5, 0.8, 1.5}};
        return scene;
    }

    static void keep_diffuse_only(Scene& scene) {
        scene.material.reflectance = {
            .ambient = {}, .diffuse = {1, 1, 1}, .specular = {}, .scatter = {}};
    }

    static double largest_difference(const imaging::LinearImage& a, const imaging::LinearImage& b) {
        double largest = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            const auto &p = a.pixels[i], &q = b.pixels[i];
            for (const float difference : {p.r - q.r, p.g - q.g, p.b - q.b})
                largest = std::max(largest, static_cast<double>(std::abs(difference)));
        }
        return largest;
    }
};

// The same light everywhere, on a ring before itself and on a plate up to its rim.
TEST_F(Separable, LeavesConstantLightAsItIs) {
    const auto ring = geometry::torus(1, 0.4, 48, 24);
    auto scene = wide_scene(ring, {0, 0, 1}, {.turn_degrees = 70});
    scene.material.reflectance = {
        .ambient = {1, 1, 1}, .diffuse = {}, .specular = {}, .scatter = {}};
    // Two sums of 25 floats that make 1.
    EXPECT_LE(largest_difference(picture(ring, PhongSettings{}, scene, size),
                                 picture(ring, SeparableSettings{}, scene, size)),
              5e-6);

    const auto plate = geometry::slab(2, 1.4, 0.3, 4);
    auto lit = wide_scene(plate, {0, 0, 1});
    keep_scatter_only(lit); // all of it where the light comes in
    const auto image = picture(plate, SeparableSettings{}, lit, size);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_NEAR(image.pixels[i].g, image.coverage[i], 5e-6F) << i;
}

// A near light makes a bright spot on a plate: it spreads, and its sum stays.  Pixels exchange with
// the same weight either way, and at the rim weights come back to the pixel that lost them: only
// rounding is left, of sums of 25 floats twice.
TEST_F(Separable, KeepsTheEnergy) {
    const auto plate = geometry::slab(2, 2, 0.1, 4);
    auto scene = wide_scene(plate, {0, 0, 1});
    scene.lights = {{PointLight{{0, 0, 8}, Millimetres{10}}, {1, 1, 1}}};
    keep_diffuse_only(scene);
    const auto sharp = picture(plate, PhongSettings{}, scene, size);
    const auto blurred = picture(plate, SeparableSettings{}, scene, size);
    glm::dvec3 sum_sharp(0), sum_blurred(0), peak_sharp(0), peak_blurred(0);
    for (std::size_t i = 0; i < sharp.pixels.size(); ++i) {
        sum_sharp += rgb(sharp.pixels[i]);
        sum_blurred += rgb(blurred.pixels[i]);
        peak_sharp = glm::max(peak_sharp, rgb(sharp.pixels[i]));
        peak_blurred = glm::max(peak_blurred, rgb(blurred.pixels[i]));
    }
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(sum_blurred[c], sum_sharp[c], 1e-4 * sum_sharp[c]) << c;
    EXPECT_LT(peak_blurred.r, 0.9 * peak_sharp.r);
    EXPECT_LT(peak_blurred.r, peak_blurred.b); // the shorter way blurs less
}

// Light through two plates and through one: a straight step on an even face.  Blurred, it is the
// profile's integral, whatever the direction of the step.
class SeparableStep : public Separable, public testing::WithParamInterface<bool> {};

TEST_P(SeparableStep, IsTheProfilesIntegral) {
    constexpr double t = 0.2, gap = 0.4;
    const bool upright = GetParam();
    const auto front = geometry::slab(2, 2, t, 4);
    const auto behind = upright ? geometry::slab(1, 2, t, 4) : geometry::slab(2, 1, t, 4);
    const glm::dvec3 half(0, 0, (t + gap) / 2);
    const auto two = geometry::together(geometry::moved(front, half), behind, -half);
    const double model_diameter = 2 * geometry::bounding_sphere(two).radius;
    const double mm = diameter.value / model_diameter;
    auto scene = wide_scene(two, {0, 0, -1});
    keep_scatter_only(scene);
    thickness::ThicknessField field;
    field.d_n = model_diameter;
    constexpr int fine = 192;
    const auto image =
        picture(two, SeparableSettings{.taps = 101, .law = Law::Paper}, scene, fine, 1, &field);

    const auto d = diffusion::diffusion_length(scene.material.medium);
    const double thin = 1 - t / model_diameter, thick = 1 - (2 * t + gap) / model_diameter;
    int between = 0;
    for (int i = 96; i < 150; ++i) { // from the middle, across the rim, not to the plate's
        const int column = upright ? i : fine / 2, row = upright ? fine / 2 : fine - 1 - i;
        const auto hit = seen_by_pixel(two, scene, column, row, fine, fine);
        ASSERT_TRUE(hit);
        const double x = (upright ? hit->point.x : hit->point.y) - 0.5 * mm;
        const auto colour = rgb(pixel(image, column, row));
        for (int c = 0; c < 3; ++c) {
            const auto up_to = [&](double edge) {
                const double beyond = diffusion::line_profile_beyond(std::abs(edge), d[c]);
                return edge < 0 ? beyond : 1 - beyond;
            };
            // The part of the profile between the rims, at 0 and at -1 model unit.
            const double passed = up_to(-x) - up_to(-x - mm);
            // A pixel is 0.54 mm wide, and the step falls somewhere in one: off by half of what the
            // profile has within a pixel, a little more as samples mix two pixels.
            const double a_pixel = 1 - 2 * diffusion::line_profile_beyond(0.27, d[c]);
            EXPECT_NEAR(colour[c], thin + passed * (thick - thin),
                        0.6 * a_pixel * (thin - thick) * std::exp(-std::abs(x) / (3 * d[c])) + 1e-3)
                << i << ' ' << c;
            between += passed > 0.05 && passed < 0.95 ? 1 : 0;
        }
    }
    EXPECT_GE(between, 6);
}

INSTANTIATE_TEST_SUITE_P(RowsAndColumns, SeparableStep, testing::Values(true, false));

// A plate far behind another: light does not jump across the gap, and none is lost.
TEST_F(Separable, FollowsTheSurfaceAcrossAStepInDepth) {
    auto two = geometry::moved(geometry::slab(1, 2, 0.1, 4), {0.5, 0, 0.6});
    two = geometry::together(two, geometry::slab(2, 2, 0.1, 4), {0, 0, -0.6});
    auto scene = wide_scene(two, {0, 0, 1});
    keep_scatter_only(scene); // on the lit side all of it, whatever the normals at the rims
    scene.lights = {{PointLight{{-20, 0, 120}}, {1, 1, 1}}};
    const auto sharp = picture(two, methods::GreenSettings{}, scene, size);
    const auto blurred = picture(two, SeparableSettings{}, scene, size);
    // The plates lie 38 mm apart: around the step e^-4 is left of the farthest samples, e^-7 of the
    // others.  Within a plate the variance 7 d^2 to an axis meets the curvature 2/h^2 of what falls
    // with the square, 0.5 %, and at a rim a one-sided kernel its slope: 0.8 d by 2 rho/(h^2 +
    // rho^2), 1 %.  Light that jumped would show by 40 %.
    const int row = size / 2;
    for (int column = 8; column < size - 8; ++column) {
        const auto here = pixel(sharp, column, row).r;
        EXPECT_NEAR(pixel(blurred, column, row).r, here, 0.05F * here) << column;
    }
}

TEST_F(Separable, KeepsHighlightsSharp) {
    const auto sphere = geometry::sphere(1, 5);
    auto scene = wide_scene(sphere, {1, 1, 1});
    scene.material.reflectance = {
        .ambient = {}, .diffuse = {}, .specular = {1, 1, 1}, .scatter = {}, .shininess = 200};
    EXPECT_LE(largest_difference(picture(sphere, PhongSettings{}, scene, size),
                                 picture(sphere, SeparableSettings{}, scene, size)),
              1e-6);
}

// Without any blur it is Green's method: the same map, the same law.
TEST_F(Separable, IsGreenWhereLightDoesNotSpread) {
    const auto ring = geometry::torus(1, 0.4, 48, 24);
    auto scene = scene_of(ring, {0.3, 0.2, -1});
    scene.material.medium = {.sigma_a = {1e-7, 2e-7, 3e-7}, .sigma_s_reduced = {1e5, 1e5, 1e5}};
    scene.lights.push_back({PointLight{{10, 80, -40}}, {0.3F, 0.2F, 0.1F}});
    for (const auto law : {Law::Physical, Law::Paper}) {
        thickness::ThicknessField field;
        field.d_n = 1.4;
        const auto green = picture(ring, methods::GreenSettings{.depth_map = 512, .law = law},
                                   scene, size, 1, &field);
        const auto separable =
            picture(ring, SeparableSettings{.depth_map = 512, .law = law}, scene, size, 1, &field);
        // 1e-5 mm of way are 1e-5 of a pixel: that much of the neighbour is mixed in.
        EXPECT_LE(largest_difference(green, separable), 1e-4);
    }
}

// Light from behind through a thin plate: what the law leaves, as the blur keeps a constant.
TEST_F(Separable, TransmitsByTheLaw) {
    const auto plate = geometry::slab(2, 2, 0.05, 4);
    auto scene = wide_scene(plate, {0, 0, -1});
    keep_scatter_only(scene);
    const double way = 0.05 * diameter.value / (2 * geometry::bounding_sphere(plate).radius);
    const auto sigma_tr = effective_transport(scene.material.medium);
    const auto colour = pixel(picture(plate, SeparableSettings{}, scene, size), size / 2, size / 2);
    EXPECT_NEAR(colour.r, std::exp(-sigma_tr.r * way), 1e-4);
    EXPECT_NEAR(colour.g, std::exp(-sigma_tr.g * way), 1e-4);
    EXPECT_NEAR(colour.b, std::exp(-sigma_tr.b * way), 1e-4);
}

TEST_F(Separable, CoversWhatEveryMethodCovers) {
    const auto ring = geometry::torus(1, 0.4, 48, 24);
    const auto scene = wide_scene(ring, {1, 1, 1});
    const auto phong = picture(ring, PhongSettings{}, scene, size, 16);
    const auto separable = picture(ring, SeparableSettings{}, scene, size, 16);
    EXPECT_EQ(separable.coverage, phong.coverage);
    for (std::size_t i = 0; i < phong.coverage.size(); ++i)
        if (phong.coverage[i] == 0) {
            EXPECT_EQ(separable.pixels[i], LinearRgb{}) << i;
        }
}

// Half of a larger frame buffer, as split views are drawn.
TEST_F(Separable, StaysWithinItsViewport) {
    const auto sphere = geometry::sphere(1, 4);
    auto scene = wide_scene(sphere, {1, 1, 1});
    keep_diffuse_only(scene);
    const auto method = prepare(sphere, SeparableSettings{.depth_map = 256});
    const auto alone = pictures::render_picture(*method, scene, size, size, 1);
    ASSERT_TRUE(alone);
    const auto target = gpu::Target::create(2 * size, size);
    ASSERT_TRUE(target);
    target->clear();
    std::vector<float> rgba;
    {
        const auto drawing = target->draw_into();
        const gpu::DrawingWithin right({size, 0, size, size});
        method->draw(scene);
    }
    target->read(rgba);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const auto left = 4 * static_cast<std::size_t>((size - 1 - row) * 2 * size + column);
            EXPECT_EQ(rgba[left + 3], 0);
            // Rasterisers round by the place in the frame buffer.
            EXPECT_NEAR(rgba[left + 4 * size], pixel(*alone, column, row).r, 1e-5F);
        }
}

TEST_F(Separable, RefusesAnEvenNumberOfTaps) {
    const auto dials = methods::complete_for("separable", {{"taps", std::int64_t{24}}});
    ASSERT_FALSE(dials);
    EXPECT_EQ(dials.error().what, "is 24, expected an odd number: one in the middle");
}

TEST_F(Separable, DrawsTheMeshTwiceForAPicture) {
    const auto method = prepare(geometry::sphere(1, 2), SeparableSettings{.depth_map = 256});
    EXPECT_EQ(method->cost().passes_per_picture, 2);
    EXPECT_EQ(method->cost().passes_per_light, 1);
    EXPECT_GE(method->cost().bytes_per_light, 256U * 256U * 4U);
}

} // namespace
