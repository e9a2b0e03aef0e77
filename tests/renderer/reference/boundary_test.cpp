#include "renderer/reference/boundary.h"
#include "renderer/reference/illumination.h"
#include "renderer/reference/microfacets.h"
#include "renderer/reference/phase.h"
#include "renderer/reference/random.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace {

using namespace renderer::reference;

const glm::dvec3 up{0, 0, 1};

glm::dvec3 downward(double cosine) {
    return {std::sqrt(1 - cosine * cosine), 0, -cosine};
}

TEST(Fresnel, HasItsKnownValues) {
    EXPECT_DOUBLE_EQ(fresnel(1, 1.5), 0.04);
    EXPECT_DOUBLE_EQ(fresnel(1, 1 / 1.5), 0.04);
    EXPECT_DOUBLE_EQ(fresnel(0, 1.5), 1);
    const double brewster = std::cos(std::atan(1.5)); // only light across the plane: half of 0.148
    EXPECT_NEAR(fresnel(brewster, 1.5), 0.5 * std::pow((1.5 * 1.5 - 1) / (1.5 * 1.5 + 1), 2),
                1e-15);
}

TEST(Fresnel, OfEqualIndicesIsExactlyNothing) {
    for (const double cosine : {0.0, 1e-300, 0.3, 1.0})
        EXPECT_EQ(fresnel(cosine, 1), 0);
    const glm::dvec3 d = glm::normalize(glm::dvec3(0.1, 0.7, -0.3));
    EXPECT_EQ(*refracted(d, up, 1), d);
}

TEST(Fresnel, IsContinuousAtTheCriticalAngle) {
    for (const double index : {1 / 1.3, 1 / 1.5, 0.75}) {
        const double critical = std::sqrt(1 - index * index);
        double around_it = std::nextafter(critical, 0);
        for (int i = 0; i < 3; ++i, around_it = std::nextafter(around_it, 1)) {
            const double f = fresnel(around_it, index);
            EXPECT_TRUE(f >= 0 && f <= 1);
            EXPECT_NEAR(f, 1, 1e-3);
        }
    }
}

TEST(Fresnel, IsTheSameFromBothSides) {
    for (const double cosine : {0.05, 0.4, 0.9}) {
        const auto behind = refracted(downward(cosine), up, 1.4);
        ASSERT_TRUE(behind);
        EXPECT_NEAR(fresnel(-behind->z, 1 / 1.4), fresnel(cosine, 1.4), 1e-13);
        const auto back = refracted(-*behind, -up, 1 / 1.4);
        ASSERT_TRUE(back);
        EXPECT_LE(glm::distance(*back, -downward(cosine)), 1e-13);
    }
}

// Tabulated to seven digits from the closed form; inside and outside are bound by an identity.
TEST(DiffuseFresnel, MeetsTheTableAndTheIdentity) {
    for (const auto& [index, outside] :
         {std::pair{1.3, 0.0611318}, {1.33, 0.0659308}, {1.4, 0.0768115}, {1.5, 0.0917780}}) {
        EXPECT_NEAR(diffuse_fresnel(index), outside, 1e-7);
        EXPECT_NEAR(diffuse_fresnel(1 / index), 1 - (1 - outside) / (index * index), 1e-6);
    }
    EXPECT_EQ(diffuse_fresnel(1), 0);
}

// What is drawn, weighted, must be what the value integrates to; 4 standard errors, 12 tests.
TEST(Microfacets, DrawWhatTheirDensitySays) {
    for (const double index : {1.3, 1 / 1.3, 1.5})
        for (const double alpha : {0.1, 0.5})
            for (const double cosine : {0.9, 0.2}) {
                const RoughSurface surface{up, alpha, index};
                const glm::dvec3 out = -downward(cosine);
                constexpr std::uint32_t n = 40'000;
                double drawn = 0, drawn_squares = 0, even = 0, even_squares = 0;
                for (std::uint32_t i = 0; i < n; ++i) {
                    PathRandom random({1, i / 64, 0, i % 64, 6});
                    const double u1 = random.next(), u2 = random.next(), u3 = random.next();
                    const auto s = sample_rough(surface, out, u1, u2, u3);
                    // any function of the direction will do
                    const double x =
                        s && s->direction.z < 0 ? s->unhidden * (1 + s->direction.x) : 0;
                    drawn += x;
                    drawn_squares += x * x;
                    const double along = random.next();
                    const glm::dvec3 in = around(-up, along, random.next());
                    const double y =
                        2 * std::numbers::pi * rough_value(surface, out, in) * (1 + in.x);
                    even += y;
                    even_squares += y * y;
                }
                const double a = drawn / n, b = even / n;
                const double se =
                    std::sqrt((drawn_squares / n - a * a + even_squares / n - b * b) / n);
                EXPECT_LE(std::abs(a - b), 4 * se) << index << ' ' << alpha << ' ' << cosine;
                EXPECT_GT(a, 0);
            }
}

Illumination sun_of(double half_angle_degrees) {
    return {.suns = {{.irradiance = {1, 1, 1},
                      .half_angle = renderer::from_degrees(half_angle_degrees)}}};
}

TEST(Illumination, ThatNoPathCanFindIsRefused) {
    const Boundary smooth{BoundaryKind::Smooth};
    for (const double degrees : {0.0, 0.25, 1.99}) {
        const auto refused = check_reachable(sun_of(degrees), smooth);
        ASSERT_FALSE(refused);
        EXPECT_THAT(refused.error(), testing::HasSubstr("expected at least 2 degrees"));
    }
    EXPECT_FALSE(check_reachable({.lamps = {{}}}, smooth));
    EXPECT_TRUE(check_reachable(sun_of(2), smooth));
    EXPECT_TRUE(check_reachable({.sky = {1, 1, 1}}, smooth));
    EXPECT_TRUE(check_reachable(sun_of(0), {BoundaryKind::Matched}));
    EXPECT_TRUE(check_reachable(sun_of(0), {BoundaryKind::Rough, 0.1}));
    EXPECT_FALSE(check_reachable(sun_of(0), {BoundaryKind::Rough, 0.05}));
}

TEST(Sun, IsSampledEvenlyOverItsDisc) {
    const Sun sun{.to_light = glm::normalize(glm::dvec3(1, 2, 3)),
                  .irradiance = {1, 1, 1},
                  .half_angle = renderer::from_degrees(30)};
    EXPECT_NEAR(solid_angle(sun), 2 * std::numbers::pi * (1 - std::cos(std::numbers::pi / 6)),
                1e-14);
    double sum = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto d = sample(sun, (i + 0.5) / 1000, 0.1 * i);
        EXPECT_TRUE(is_toward(sun, d));
        sum += glm::dot(d, sun.to_light);
    }
    EXPECT_NEAR(sum / 1000, (1 + std::cos(std::numbers::pi / 6)) / 2, 1e-6); // mean cosine of a cap
}

} // namespace
