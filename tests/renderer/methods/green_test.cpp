#include "renderer/geometry/bodies.h"
#include "renderer/methods/green.h"
#include "tests/renderer/methods/known_worlds.h"

namespace {

using namespace known_worlds;
using methods::GreenSettings;
using methods::Law;

// Under the paper's law with only the scatter term, a picture says its thickness: s = D_n (1 - I).
class Green : public MethodTest {
  protected:
    static constexpr int size = 65;
    static constexpr int resolution = 1024;

    // Thickness in mm; the body is 100 mm across, as is D_n.
    std::vector<double> thickness_seen(const geometry::Mesh& mesh, Scene scene) {
        keep_scatter_only(scene);
        thickness::ThicknessField field;
        field.d_n = 2 * geometry::bounding_sphere(mesh).radius;
        const GreenSettings settings{.depth_map = resolution, .law = Law::Paper};
        const auto image = picture(mesh, settings, scene, size, 1, &field);
        std::vector<double> s;
        for (const auto& colour : image.pixels)
            s.push_back(diameter.value * (1 - static_cast<double>(colour.g)));
        return s;
    }

    static double at_centre(const std::vector<double>& s) {
        return s[static_cast<std::size_t>(size / 2 * size + size / 2)];
    }

    static constexpr double texel = diameter.value / resolution;
};

TEST_F(Green, SeesTheChordOfASphereToATexel) {
    const auto sphere = geometry::sphere(1, 6);
    const auto scene = scene_of(sphere, {0, 0, -1});
    const auto s = thickness_seen(sphere, scene);
    const double R = diameter.value / 2;
    int checked = 0;
    for (int row = 0; row < size; row += 3)
        for (int column = 0; column < size; column += 3) {
            const auto hit = seen_by_pixel(sphere, scene, column, row, size, size);
            if (!hit)
                continue;
            const double rho = glm::length(glm::dvec2(hit->point));
            if (rho > 0.9 * R)
                continue; // the slope runs away at the silhouette
            const double tangent = rho / std::sqrt(R * R - rho * rho);
            const double chord = 2 * std::sqrt(R * R - rho * rho);
            // The bias, half a texel's diagonal down the slope, and the mesh inside the sphere:
            // 1.5e-4 R at both ends for edges of R/55, over the cosine.
            const double tolerance = texel * std::min(tangent, 4.0) + 0.71 * texel * tangent +
                                     3e-4 * R * std::sqrt(1 + tangent * tangent);
            EXPECT_NEAR(s[static_cast<std::size_t>(row * size + column)], chord, tolerance)
                << column << ' ' << row;
            ++checked;
        }
    EXPECT_GT(checked, 100);
}

TEST_F(Green, LitSideHasNoThickness) {
    const auto sphere = geometry::sphere(1, 5);
    const auto scene = scene_of(sphere, {0, 0, 1});
    const auto s = thickness_seen(sphere, scene);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const double x = column - size / 2, y = row - size / 2;
            // Within 3/4 of the picture's radius the slope stays below the bias's largest.
            if (std::hypot(x, y) >= 0.75 * size / 2)
                continue;
            EXPECT_EQ(s[static_cast<std::size_t>(row * size + column)], 0) << column << ' ' << row;
        }
}

// Its expected failure: on the shell's axis lie 1.0 of material, and Green sees 2.0 (in radii).
TEST_F(Green, CountsTheCavityOfAShellAsMaterial) {
    const auto shell = geometry::shell(1, 0.5, 5);
    const auto s = thickness_seen(shell, scene_of(shell, {0, 0, -1}));
    const double R = diameter.value / 2;
    EXPECT_NEAR(at_centre(s), 2.0 * R, texel + 1e-3 * R);
}

TEST_F(Green, CountsTheGapBetweenTwoSlabsAsMaterial) {
    constexpr double t = 0.2, gap = 0.5;
    geometry::Mesh two;
    for (const double side : {-1.0, 1.0}) {
        const auto one = geometry::slab(2, 2, t, 4);
        const auto first = static_cast<std::uint32_t>(two.positions.size());
        for (const auto& position : one.positions)
            two.positions.push_back(position + glm::dvec3(0, 0, side * (t + gap) / 2));
        for (const auto& triangle : one.triangles)
            two.triangles.push_back(
                {triangle[0] + first, triangle[1] + first, triangle[2] + first});
    }
    const double mm = diameter.value / (2 * geometry::bounding_sphere(two).radius);
    const auto s = thickness_seen(two, scene_of(two, {0, 0, -1}));
    // The slabs face the light: no slope, no bias.  Float depths over 100 mm keep 1e-5 mm.
    EXPECT_NEAR(at_centre(s), (2 * t + gap) * mm, 1e-4);
}

TEST_F(Green, AttenuatesLikeShss) {
    const auto sphere = geometry::sphere(1, 5);
    auto scene = scene_of(sphere, {0, 0, -1});
    keep_scatter_only(scene);
    const auto centre = pixel(picture(sphere, GreenSettings{.depth_map = resolution}, scene, size),
                              size / 2, size / 2);
    const auto sigma_tr = effective_transport(scene.material.medium);
    // The chord is 100 mm within 0.2 mm: 4 % of e^-25 and less.
    EXPECT_NEAR(centre.r, std::exp(-sigma_tr.r * 100), 0.04 * std::exp(-sigma_tr.r * 100));
    EXPECT_NEAR(centre.g, std::exp(-sigma_tr.g * 100), 0.04 * std::exp(-sigma_tr.g * 100));
}

TEST_F(Green, ThicknessIsNeverNegativeUnderGrazingLight) {
    const auto body = geometry::torus(1, 0.4, 64, 32);
    for (const auto& L : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 1e-4), glm::dvec3(-1, 1, 1)}) {
        const auto s = thickness_seen(body, scene_of(body, L));
        for (const double d : s) {
            EXPECT_GE(d, 0);
            EXPECT_LE(d, diameter.value);
        }
    }
}

TEST_F(Green, SaysWhatItCannotPrepare) {
    const auto surface = *methods::Surface::upload(geometry::sphere(1, 2));
    const auto error = [&](const GreenSettings& settings) {
        const auto method = make(settings, surface, nullptr);
        return method ? std::string("no error") : method.error();
    };
    EXPECT_THAT(error({.depth_map = 0}),
                testing::StartsWith("a depth map of 0 x 0 texels, expected 1 to "));
    EXPECT_THAT(error({.depth_map = 1 << 20}),
                testing::StartsWith("a depth map of 1048576 x 1048576 texels"));
    EXPECT_EQ(error({.law = Law::Paper}),
              "the paper's law divides by D_n, expected a thickness field");
}

TEST_F(Green, DrawsTheMeshOnceMoreForEveryLight) {
    const auto method = prepare(geometry::sphere(1, 2), GreenSettings{.depth_map = 256});
    EXPECT_EQ(method->cost().passes_per_light, 1);
    EXPECT_GE(method->cost().bytes_per_light, 256U * 256U * 4U);
    EXPECT_EQ(method->cost().bytes_per_vertex, 0U);
}

} // namespace
