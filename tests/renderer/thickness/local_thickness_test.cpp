#include "renderer/geometry/bodies.h"
#include "renderer/harmonics/directions.h"
#include "renderer/thickness/local_thickness.h"
#include "tests/renderer/methods/known_worlds.h"

#include <algorithm>

namespace {

using namespace known_worlds;
using thickness::local_thickness;

// The mean of 2R cos over the inner hemisphere, weighted by the cosine: (2R/pi) int cos^2 = 4R/3.
TEST(LocalThickness, OfASphereIsFourThirdsOfItsRadius) {
    constexpr double R = 3;
    const auto sphere = geometry::sphere(R, 3);
    const auto field = sphere_field(sphere, R, 5);
    const auto thickness = local_thickness(sphere, field);
    ASSERT_TRUE(thickness) << thickness.error();
    ASSERT_EQ(thickness->size(), sphere.positions.size());
    // Five bands hold 1/2 + 2/3 + 5/32 + 1/128 of R; the rest are 0.0026 R.  The mesh's normals are
    // off by some 1e-2, from a maximum that is flat.
    constexpr double five_bands = 1.0 / 2 + 2.0 / 3 + 5.0 / 32 + 1.0 / 128;
    EXPECT_NEAR(five_bands, 4.0 / 3, 0.0027);
    for (const double d : *thickness)
        EXPECT_NEAR(d, five_bands * R, 5e-4 * R);
}

// Against the integral itself, on bodies with nothing round about them.
TEST(LocalThickness, IsTheCosineWeightedMeanOfWhatIsTraced) {
    const auto body = geometry::rounded_box({1, 0.6, 0.3}, 0.2, 8);
    const auto field = thickness::compute_thickness_field(body, {.directions = 1024});
    ASSERT_TRUE(field) << field.error();
    const auto set = harmonics::fibonacci_directions(2048, 7);
    const auto traced = thickness::trace_thickness(body, thickness::Kind::Sum, set.directions);
    const auto thickness = local_thickness(body, *field);
    ASSERT_TRUE(traced && thickness);
    const auto normals = geometry::vertex_normals(body);
    double worst = 0, largest = 0;
    for (std::size_t v = 0; v < normals.size(); ++v) {
        double sum = 0;
        for (std::size_t k = 0; k < set.directions.size(); ++k)
            sum += std::max(-glm::dot(normals[v], set.directions[k]), 0.0) *
                   (*traced)[v * set.directions.size() + k];
        const double mean = sum * 4 / static_cast<double>(set.directions.size());
        worst = std::max(worst, std::abs((*thickness)[v] - mean));
        largest = std::max(largest, mean);
    }
    // Band 6 passes with 1/64, of thickness that has at most a tenth there; 1024 directions leave
    // less than 0.3 % of kinked functions.
    EXPECT_LE(worst, 0.01 * largest);
}

TEST(LocalThickness, RefusesAFieldOfAnotherMesh) {
    const auto small = geometry::sphere(1, 1), large = geometry::sphere(1, 2);
    const auto thickness = local_thickness(large, sphere_field(small, 1, 2));
    ASSERT_FALSE(thickness);
    EXPECT_EQ(thickness.error(),
              "a thickness field of 168 coefficients, expected 648 for 162 vertices");
}

} // namespace
