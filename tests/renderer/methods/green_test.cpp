#include "renderer/geometry/bodies.h"
#include "renderer/geometry/crossings.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/methods/catalogue.h"
#include "renderer/methods/green.h"
#include "tests/renderer/geometry/assembly.h"
#include "tests/renderer/methods/known_worlds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace {

using namespace known_worlds;
using methods::BlurredMap;
using methods::GreenSettings;
using methods::NearestMap;
using methods::PeeledMap;
using shading::Law;

/// Two plates of thickness t across the z axis, `gap` between them; the one behind (toward -z) is
/// as wide as `behind`, the one before 2.
geometry::Mesh two_plates(double behind, double t, double gap) {
    const glm::dvec3 half(0, 0, (t + gap) / 2);
    const auto front = geometry::moved(geometry::slab(2, 2, t, 4), half);
    return geometry::together(front, geometry::slab(behind, behind, t, 4), -half);
}

using Variety = decltype(GreenSettings::map);

// Under the paper's law with only the scatter term, a picture says its thickness: s = D_n (1 - I).
class Green : public MethodTest {
  protected:
    static constexpr int size = 65;
    static constexpr int resolution = 1024;

    // Thickness in mm; the body is 100 mm across, as is D_n.
    std::vector<double> thickness_seen(const geometry::Mesh& mesh,
                                       Scene scene,
                                       const Variety& map = {},
                                       int texels = resolution) {
        keep_scatter_only(scene);
        thickness::ThicknessField field;
        field.d_n = 2 * geometry::bounding_sphere(mesh).radius;
        const GreenSettings settings{.depth_map = texels, .law = Law::Paper, .map = map};
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

// Blurring does not help: the mean of the entry depths around the pole, R - sqrt(R^2 - rho^2), is
// s^2/R deep for a deviation s, 0.08 mm here.
TEST_F(Green, CountsTheCavityOfAShellAsMaterialWhenBlurred) {
    const auto shell = geometry::shell(1, 0.5, 5);
    const auto s = thickness_seen(shell, scene_of(shell, {0, 0, -1}), BlurredMap{Millimetres{2}});
    const double R = diameter.value / 2;
    EXPECT_NEAR(at_centre(s), 2.0 * R - 4 / R, 1e-3 * R);
}

TEST_F(Green, SeesOnlyTheMaterialOfAShellWhenPeeled) {
    const auto shell = geometry::shell(1, 0.5, 5);
    const auto s = thickness_seen(shell, scene_of(shell, {0, 0, -1}), PeeledMap{4});
    const double R = diameter.value / 2;
    // Every one of four surfaces may lie 1e-3 R inside its sphere.
    EXPECT_NEAR(at_centre(s), 1.0 * R, texel + 4e-3 * R);
}

// With too few layers what is seen is counted, and the rest of the way is not: half a shell.
TEST_F(Green, CountsWhatItsLayersHold) {
    const auto shell = geometry::shell(1, 0.5, 5);
    const auto s = thickness_seen(shell, scene_of(shell, {0, 0, -1}), PeeledMap{2});
    const double R = diameter.value / 2;
    EXPECT_NEAR(at_centre(s), 0.5 * R, texel + 2e-3 * R);
}

TEST_F(Green, CountsTheGapBetweenTwoSlabsAsMaterialUnlessItIsPeeled) {
    constexpr double t = 0.2, gap = 0.5;
    const auto two = two_plates(2, t, gap);
    const double mm = diameter.value / (2 * geometry::bounding_sphere(two).radius);
    const auto scene = scene_of(two, {0, 0, -1});
    // The slabs face the light: no slope, no bias.  The thickness comes back through a float of
    // 1 - d/D_n, 6e-8 of 100 mm, from positions in floats of 100 mm, 4e-6 each.
    constexpr double floats = 1e-4;
    EXPECT_NEAR(at_centre(thickness_seen(two, scene)), (2 * t + gap) * mm, floats);
    EXPECT_NEAR(at_centre(thickness_seen(two, scene, BlurredMap{Millimetres{1}})),
                (2 * t + gap) * mm, floats);
    EXPECT_NEAR(at_centre(thickness_seen(two, scene, PeeledMap{4})), 2 * t * mm, floats);
}

// What "to texel accuracy" means: the traced material of some ray within a texel of the point's.
struct Bracket {
    double least = INFINITY, most = 0;
};

Bracket traced_around(geometry::InteriorTracer& tracer,
                      const Scene& scene,
                      glm::dvec3 point,
                      glm::dvec3 to_light,
                      double reach) {
    const auto helper = std::abs(to_light.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const auto u = glm::normalize(glm::cross(helper, to_light)), v = glm::cross(to_light, u);
    const auto model_from_world = glm::inverse(scene.placement.world_from_model);
    const auto way = glm::dvec3(model_from_world * glm::dvec4(to_light, 0));
    Bracket bracket;
    for (const double a : {-1.0, -0.5, 0.0, 0.5, 1.0})
        for (const double b : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            const auto origin = model_from_world * glm::dvec4(point + reach * (a * u + b * v), 1);
            double sum = 0;
            for (const auto& segment : tracer.from_point(glm::dvec3(origin), glm::normalize(way)))
                sum += segment.end - segment.begin;
            bracket.least = std::min(bracket.least, sum / glm::length(way));
            bracket.most = std::max(bracket.most, sum / glm::length(way));
        }
    return bracket;
}

// Shell, slabs and ring lit aslant: the peeled sum is the traced `sum`.  The bias takes up to four
// texels from it.
TEST_F(Green, EqualsTheTracedSumToATexelWhenPeeled) {
    const std::array bodies{geometry::shell(1, 0.5, 4), two_plates(2, 0.2, 0.5),
                            geometry::torus(1, 0.4, 48, 24)};
    for (const auto& body : bodies) {
        const geometry::RayScene rays(body);
        geometry::InteriorTracer tracer(rays);
        for (const auto& L : {glm::dvec3(0.3, 0.2, -1), glm::dvec3(-1, 0.4, 0.3)}) {
            const auto scene = scene_of(body, L);
            const auto s = thickness_seen(body, scene, PeeledMap{8});
            int checked = 0;
            for (int row = 1; row < size; row += 5)
                for (int column = 1; column < size; column += 5) {
                    const auto hit = seen_by_pixel(body, scene, column, row, size, size);
                    if (!hit)
                        continue;
                    const auto truth =
                        traced_around(tracer, scene, hit->point, glm::normalize(L), texel);
                    const double seen = s[static_cast<std::size_t>(row * size + column)];
                    EXPECT_GE(seen, truth.least - 4 * texel - 1e-3) << column << ' ' << row;
                    EXPECT_LE(seen, truth.most + 1e-3) << column << ' ' << row;
                    ++checked;
                }
            EXPECT_GT(checked, 40);
        }
    }
}

// A narrow plate behind a wide one throws its rim into the map: across it the thickness jumps by
// the depth step, t + gap, between two neighbouring pixels.
class GreenAtARim : public Green {
  protected:
    static constexpr double t = 0.2, gap = 0.4, width = 1;
    geometry::Mesh two = two_plates(width, t, gap);
    Scene scene = scene_of(two, {0, 0, -1});
    double mm = diameter.value / (2 * geometry::bounding_sphere(two).radius);

    /// x in mm of the front face that a pixel of the middle row sees.
    double x_of(int column) const {
        return seen_by_pixel(two, scene, column, size / 2, size, size)->point.x;
    }

    static std::vector<double> middle_row(const std::vector<double>& s) {
        const auto first = s.begin() + size / 2 * size;
        return {first, first + size};
    }
};

TEST_F(GreenAtARim, JumpsByTheDepthStep) {
    const auto s = middle_row(thickness_seen(two, scene));
    double largest_jump = 0;
    for (int column = 14; column < size - 14; ++column) {
        const auto i = static_cast<std::size_t>(column);
        const double x = x_of(column), rim = width / 2 * mm;
        // Toward the wide plate's edges its normals bend outward, by up to 55 degrees, and the bias
        // takes a texel times that slope.
        if (std::abs(std::abs(x) - rim) > texel) {
            const double way = (std::abs(x) < rim ? 2 * t + gap : t) * mm;
            EXPECT_LE(s[i], way + 1e-4) << x;
            EXPECT_GE(s[i], way - 1.5 * texel) << x;
        }
        largest_jump = std::max(largest_jump, std::abs(s[i + 1] - s[i]));
    }
    EXPECT_NEAR(largest_jump, (t + gap) * mm, 1.5 * texel);
}

// Blurred, the step becomes the Gaussian's integral across the rim.
TEST_F(GreenAtARim, SpreadsTheStepWhenBlurred) {
    constexpr double deviation = 3;
    const auto s = middle_row(thickness_seen(two, scene, BlurredMap{Millimetres{deviation}}));
    // The blurred map has eight texels to a deviation: the rim is up to half of one aside, which
    // the steepest slope 1/(deviation sqrt(2 pi)) makes 2.5 % of the step; the cut at three
    // deviations adds 0.3 %.
    const double tolerance = (0.5 / 8 / std::sqrt(2 * std::numbers::pi) + 0.003) * (t + gap) * mm;
    int between = 0;
    for (int column = 14; column < size - 14; ++column) {
        const double x = x_of(column), rim = width / 2 * mm;
        const auto covered = [&](double edge) {
            return 0.5 * std::erfc((x - edge) / (deviation * std::sqrt(2)));
        };
        const double before = covered(rim) - covered(-rim);
        EXPECT_NEAR(s[static_cast<std::size_t>(column)], (t + before * (t + gap)) * mm, tolerance)
            << x;
        between += before > 0.05 && before < 0.95 ? 1 : 0;
    }
    EXPECT_GE(between, 4);
}

// Nothing bleeds in from the empty texels around the body: up to its rim a plate is as thick as it
// is.
TEST_F(Green, HasNoRimWhenBlurred) {
    const auto plate = geometry::slab(2, 2, 0.3, 4);
    const auto scene = scene_of(plate, {0, 0, -1});
    const double mm = diameter.value / (2 * geometry::bounding_sphere(plate).radius);
    const auto s = thickness_seen(plate, scene, BlurredMap{Millimetres{5}});
    int checked = 0;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const auto hit = seen_by_pixel(plate, scene, column, row, size, size);
            if (!hit || std::abs(hit->point.z - 0.15 * mm) > 1e-6)
                continue;
            EXPECT_NEAR(s[static_cast<std::size_t>(row * size + column)], 0.3 * mm, 1e-4)
                << column << ' ' << row;
            ++checked;
        }
    EXPECT_GT(checked, 1000);
}

TEST_F(Green, BlursByTheDiffusionLengthButNoMoreThanATwentieth) {
    const auto sphere = geometry::sphere(1, 2);
    const auto method = prepare(sphere, GreenSettings{.map = BlurredMap{}});
    EXPECT_EQ(method->decision(), "");
    auto scene = scene_of(sphere, {0, 0, -1});
    scene.material.medium.sigma_a = {0.1, 0.2, 0.3};
    ASSERT_TRUE(method->update(scene));
    const auto sigma_tr = effective_transport(scene.material.medium);
    EXPECT_EQ(method->decision(),
              fmt::format("blurred by {:.3g} mm", 3 / (sigma_tr.r + sigma_tr.g + sigma_tr.b)));
    scene.material.medium.sigma_a = {0, 0, 0}; // the diffusion length is infinite
    ASSERT_TRUE(method->update(scene));
    EXPECT_EQ(method->decision(), "blurred by 5 mm");
}

// A plate under light that grazes it at a slope of 20: the bias takes 4 texels, not 20.  Within a
// texel the depth is off by up to 10 texels either way, evenly, and alike down a column of pixels,
// so the mean over n columns is off by 20/sqrt(12 n); 3 standard errors.
TEST_F(Green, ClampsItsBiasUnderGrazingLight) {
    const auto plate = geometry::slab(2, 2, 0.01, 4);
    constexpr double slope = 20;
    const auto scene = scene_of(plate, {slope, 0, -1});
    const double mm = diameter.value / (2 * geometry::bounding_sphere(plate).radius);
    const double way = 0.01 * mm * std::sqrt(1 + slope * slope);
    const auto s = thickness_seen(plate, scene, NearestMap{}, 4096);
    const double fine = diameter.value / 4096;
    double sum = 0;
    int count = 0, columns = 0;
    for (int column = 0; column < size; ++column) {
        const int before = count;
        for (int row = 0; row < size; ++row) {
            const auto hit = seen_by_pixel(plate, scene, column, row, size, size);
            // Nearer to the lit edge the light comes in through it.
            if (!hit || hit->point.x > mm - 1.5 * way)
                continue;
            sum += s[static_cast<std::size_t>(row * size + column)];
            ++count;
        }
        columns += count > before ? 1 : 0;
    }
    ASSERT_GT(columns, 25);
    EXPECT_NEAR(sum / count, way - 4 * fine, 3 * slope * fine / std::sqrt(12.0 * columns));
}

TEST_F(Green, IsMirroredWithItsBody) {
    const auto shell = geometry::shell(1, 0.5, 4);
    auto scene = scene_of(shell, {0, 0, -1});
    const auto plain = thickness_seen(shell, scene, PeeledMap{4});
    scene.placement.world_from_model[0] *= -1;
    const auto mirrored = thickness_seen(shell, scene, PeeledMap{4});
    EXPECT_NEAR(at_centre(mirrored), at_centre(plain), 4 * texel);
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
    for (const Variety& map :
         {Variety(NearestMap{}), Variety(BlurredMap{Millimetres{2}}), Variety(PeeledMap{})})
        for (const auto& L : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 1e-4), glm::dvec3(-1, 1, 1)})
            for (const double d : thickness_seen(body, scene_of(body, L), map)) {
                EXPECT_GE(d, 0);
                EXPECT_LE(d, diameter.value);
            }
}

TEST_F(Green, SaysWhatItCannotPrepare) {
    const auto surface = *shading::Surface::upload(geometry::sphere(1, 2));
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

// By the dials alone, long before anything is drawn.
TEST(GreenPeel, RefusesMapsThatNoMachineHolds) {
    const auto refused = [](std::int64_t layers, std::int64_t depth_map) {
        const auto dials =
            methods::complete_for("green-peel", {{"layers", layers}, {"depth_map", depth_map}});
        return dials ? "no error" : dials.error().dial + " " + dials.error().what;
    };
    EXPECT_EQ(
        refused(64, 16384),
        "layers is 64 of 16384 x 16384 texels, a map of 64.0 GiB for every light, expected at "
        "most 4 GiB: 4 layers, or a smaller depth_map");
    EXPECT_EQ(refused(4, 16384), "no error");
    EXPECT_THAT(refused(5, 16384), testing::HasSubstr("a map of 5.0 GiB"));
    EXPECT_EQ(refused(64, 4096), "no error");
}

TEST_F(Green, DrawsTheMeshOnceMoreForEveryLight) {
    const auto method = prepare(geometry::sphere(1, 2), GreenSettings{.depth_map = 256});
    EXPECT_EQ(method->cost().passes_per_light, 1);
    EXPECT_GE(method->cost().bytes_per_light, 256U * 256U * 4U);
    EXPECT_EQ(method->cost().bytes_per_vertex, 0U);
    const auto peeled =
        prepare(geometry::sphere(1, 2), GreenSettings{.depth_map = 256, .map = PeeledMap{4}});
    EXPECT_EQ(peeled->cost().passes_per_light, 4);
}

} // namespace
