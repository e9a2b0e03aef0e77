#include "renderer/reference/phase.h"
#include "renderer/reference/random.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace renderer::reference;

// Over s = log(1 - cos + small) the forward peak is smooth: midpoints then converge for every g.
double integral(double g, auto&& weight) {
    constexpr int n = 200'000;
    const double sign = g < 0 ? -1 : 1, least = 1e-9;
    const double low = std::log(least), high = std::log(2 + least);
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double x = std::exp(low + (high - low) * (i + 0.5) / n);
        const double cosine = sign * (1 - (x - least));
        sum += 2 * std::numbers::pi * henyey_greenstein(cosine, g) * weight(cosine) * x;
    }
    return sum * (high - low) / n;
}

TEST(HenyeyGreenstein, IntegratesToOneAndHasMeanCosineG) {
    for (const double g : {0.0, 1e-8, 0.3, -0.5, 0.9, 0.99, -0.999, 0.999}) {
        // the first 1e-9 of 1 - cos are left out: p there is at most 1 / (2 pi (1 - g)^2)
        EXPECT_NEAR(integral(g, [](double) { return 1.0; }), 1, 2e-3) << g;
        EXPECT_NEAR(integral(g, [](double c) { return c; }), g, 2e-3) << g;
    }
}

// The distribution function in closed form undoes the sampling.
TEST(HenyeyGreenstein, SamplesInvertTheDistributionFunction) {
    for (const double g : {1e-4, 0.1, 0.499, -0.499, 0.5, 0.9, -0.9, 0.999}) {
        double last = -1;
        for (int i = 0; i <= 64; ++i) {
            const double u = i / 64.0, c = sample_henyey_greenstein(u, g);
            EXPECT_GE(c, last);
            last = c;
            const double root = std::sqrt(1 + g * g - 2 * g * c);
            const double back = (1 - g * g) / (2 * g) * (1 / root - 1 / (1 + g));
            EXPECT_NEAR(back, u, 1e-10) << g;
        }
    }
}

TEST(HenyeyGreenstein, SamplesHaveMeanCosineG) {
    for (const double g : {0.0, 1e-8, 0.3, -0.3, 0.9, 0.999, -0.999}) {
        constexpr int n = 100'000;
        double sum = 0, squares = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            const double c = sample_henyey_greenstein(PathRandom({3, i, 0, 0, 0}).next(), g);
            ASSERT_TRUE(std::abs(c) <= 1);
            sum += c;
            squares += c * c;
        }
        const double mean = sum / n, se = std::sqrt((squares / n - mean * mean) / n);
        EXPECT_LE(std::abs(mean - g), 4 * se) << g; // 7 tests, one in 2000 fails by chance
    }
}

TEST(HenyeyGreenstein, EndsAtStraightOnAndStraightBack) {
    for (const double g : {-0.999, -0.4, 0.0, 0.4, 0.999}) {
        EXPECT_NEAR(sample_henyey_greenstein(0, g), -1, 1e-9);
        EXPECT_NEAR(sample_henyey_greenstein(1, g), 1, 1e-9);
    }
}

TEST(Around, TurnsByTheAngleAsked) {
    for (const glm::dvec3 axis : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0),
                                  glm::normalize(glm::dvec3(1e-9, -1e-9, -1))})
        for (const double cosine : {-1.0, -0.3, 0.0, 0.999999, 1.0})
            for (const double turn : {0.0, 0.25, 0.8}) {
                const auto d = around(axis, cosine, turn);
                EXPECT_NEAR(glm::length(d), 1, 1e-14);
                EXPECT_NEAR(glm::dot(d, axis), cosine, 1e-14);
            }
}

} // namespace
