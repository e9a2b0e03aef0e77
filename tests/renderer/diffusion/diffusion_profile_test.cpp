#include "renderer/diffusion/diffusion_profile.h"

#include <glm/vec3.hpp>

#include <cmath>
#include <numbers>

namespace {

using namespace renderer;
using namespace renderer::diffusion;

/// Burley's profile as it is written.
double radial_profile(double r, double d) {
    return (std::exp(-r / d) + std::exp(-r / (3 * d))) / (8 * std::numbers::pi * d * r);
}

TEST(DiffusionProfile, IsTheRadialOneIntegratedAcross) {
    constexpr double d = 0.7;
    for (const double x : {0.05, 0.3, 1.0, 4.0}) {
        // y = x sinh t makes r = x cosh t and dy = r dt: smooth, and the trapezoid rule exact to
        // rounding.
        double sum = radial_profile(x, d) * x / 2;
        constexpr double h = 1.0 / 64;
        for (double t = h; t < 12; t += h)
            sum += radial_profile(x * std::cosh(t), d) * x * std::cosh(t);
        EXPECT_NEAR(line_profile(x, d), 2 * sum * h, 1e-12 * line_profile(x, d));
    }
}

// Bessel's K0 from the standard library.
TEST(DiffusionProfile, IsTwoBesselFunctions) {
    for (const double x : {0.01, 0.5, 2.0, 20.0})
        EXPECT_NEAR(line_profile(x, 1),
                    (std::cyl_bessel_k(0.0, x) + std::cyl_bessel_k(0.0, x / 3)) /
                        (4 * std::numbers::pi),
                    1e-10 * line_profile(x, 1))
            << x;
}

TEST(DiffusionProfile, HasHalfOfItsLightOnEitherSide) {
    EXPECT_EQ(line_profile_beyond(0, 2), 0.5);
    EXPECT_NEAR(line_profile_beyond(1e-12, 2), 0.5, 1e-10);
    EXPECT_LE(line_profile_beyond(1e4, 2), 1e-300);
    EXPECT_EQ(line_profile_beyond(1, 0), 0);
}

TEST(DiffusionProfile, FallsBeyondByWhatLiesBetween) {
    constexpr double d = 1.3, from = 0.2, to = 3.0;
    constexpr int n = 4000; // Simpson: h^4 of a profile that bends by 1/x^5
    const double h = (to - from) / n;
    double sum = line_profile(from, d) + line_profile(to, d);
    for (int i = 1; i < n; ++i)
        sum += (i % 2 == 1 ? 4 : 2) * line_profile(from + i * h, d);
    EXPECT_NEAR(line_profile_beyond(from, d) - line_profile_beyond(to, d), sum * h / 3, 1e-10);
}

// The reflectance is the dipole's total over a plane, methods page D2: 0.4040250 for sigma_a 0.1,
// sigma_s' 1, matched boundary.
TEST(DiffusionLength, IsTheMeanFreePathOverBurleysScale) {
    const Medium medium{.sigma_a = {0, 0.1, 0}, .sigma_s_reduced = {2, 1, 0}, .index = 1};
    const auto d = diffusion_length(medium);
    EXPECT_NEAR(d.r, 0.5 / (0.9 + 3.5 * 0.04), 1e-12); // nothing absorbed: A = 1
    const double A = 0.4040250;
    EXPECT_NEAR(d.g, 1 / 1.1 / (1.9 - A + 3.5 * (A - 0.8) * (A - 0.8)), 1e-6);
    EXPECT_EQ(d.b, 0);
}

TEST(DiffusionTaps, ShareAllLightInEveryChannel) {
    for (const int count : {3, 7, 25, 101}) {
        const auto taps = diffusion_taps({0.5, 1, 0}, count);
        ASSERT_EQ(taps.size(), static_cast<std::size_t>(count));
        glm::dvec3 sum(0);
        for (std::size_t i = 0; i < taps.size(); ++i) {
            const auto& opposite = taps[taps.size() - 1 - i];
            EXPECT_EQ(taps[i].offset, -opposite.offset);
            EXPECT_EQ(taps[i].weight, opposite.weight);
            if (i > 0) {
                EXPECT_GT(taps[i].offset, taps[i - 1].offset);
            }
            for (int c = 0; c < 3; ++c)
                EXPECT_GE(taps[i].weight[c], 0);
            sum += taps[i].weight;
        }
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(sum[c], 1, 1e-13) << count;
        EXPECT_EQ(taps[taps.size() / 2].weight.z, 1); // no length, no blur
    }
}

TEST(DiffusionTaps, HaveWhatTheProfileHasBeyondAnyHalfWay) {
    const auto taps = diffusion_taps({0.4, 0.4, 0.4}, 25);
    double beyond = 0;
    for (std::size_t i = taps.size() - 1; i > 12; --i) {
        beyond += taps[i].weight.x;
        EXPECT_NEAR(beyond, line_profile_beyond((taps[i].offset + taps[i - 1].offset) / 2, 0.4),
                    1e-13);
    }
}

} // namespace
