// Closed-form thickness against simpler forms, and against counting along the ray.
#include "renderer/geometry/body_thickness.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace {

using namespace renderer::geometry;

glm::dvec3 random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

/// Steps along the ray and asks at each whether it is inside: slow, and right to about 2 steps.
BodyThickness by_counting(const std::function<bool(glm::dvec3)>& inside,
                          glm::dvec3 p,
                          glm::dvec3 s,
                          double reach) {
    const int steps = 40000;
    const double step = reach / steps;
    BodyThickness result;
    bool in_first = true;
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) * step;
        const bool is_inside = inside(p + t * s);
        in_first = in_first && is_inside;
        result.first += in_first ? step : 0;
        result.sum += is_inside ? step : 0;
        if (is_inside)
            result.span = t + 0.5 * step;
    }
    return result;
}

void expect_near(const BodyThickness& a, const BodyThickness& b, double tolerance) {
    EXPECT_NEAR(a.sum, b.sum, tolerance);
    EXPECT_NEAR(a.first, b.first, tolerance);
    EXPECT_NEAR(a.span, b.span, tolerance);
}

TEST(SphereThickness, FromItsSurfaceIsTwiceRadiusTimesCosine) { // methods A6: d = 2R (-x)+
    std::mt19937_64 random(1);
    for (int i = 0; i < 1000; ++i) {
        const auto n = random_direction(random), s = random_direction(random);
        const double expected = 2 * 3 * std::max(0.0, -glm::dot(n, s));
        expect_near(sphere_thickness(3, 3.0 * n, s), {expected, expected, expected}, 3e-8);
    }
}

TEST(SphereThickness, AtGrazingIsTinyAndNeverNegative) {
    for (const double x : {-1e-7, -1e-12, 0.0, 1e-12, 1e-7}) {
        const auto d = sphere_thickness(1, {0, 0, 1}, {std::sqrt(1 - x * x), 0, x});
        EXPECT_GE(d.sum, 0);
        EXPECT_NEAR(d.sum, 2 * std::max(0.0, -x), 1e-12);
    }
}

TEST(EllipsoidThickness, FromItsSurfaceIsItsOwnFormula) { // d = max(0, -2 (p.Qs) / (s.Qs))
    const glm::dvec3 axes{3, 1, 0.5}, q = 1.0 / (axes * axes);
    std::mt19937_64 random(2);
    for (int i = 0; i < 1000; ++i) {
        const auto p = axes * random_direction(random), s = random_direction(random);
        const double expected = std::max(0.0, -2 * glm::dot(p, q * s) / glm::dot(s, q * s));
        expect_near(ellipsoid_thickness(axes, p, s), {expected, expected, expected}, 1e-7);
    }
}

TEST(ShellThickness, FromThePoleThroughTheCentreHasThreeMeanings) { // methods A11
    expect_near(shell_thickness(1, 0.5, {0, 0, 1}, {0, 0, -1}), {1.0, 0.5, 2.0}, 1e-15);
}

TEST(ShellThickness, FromTheCavityBeginsWithAGap) {
    expect_near(shell_thickness(1, 0.5, {0, 0, 0}, {0, 0, -1}), {0.5, 0, 1.0}, 1e-15);
    expect_near(shell_thickness(1, 0.5, {0, 0, 0.5}, {0, 0, -1}), {0.5, 0, 1.5}, 1e-15);
}

TEST(ShellThickness, AgreesWithCounting) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 200; ++i) {
        const auto p = random_direction(random), s = random_direction(random);
        auto inside = [](glm::dvec3 x) { return glm::length(x) < 1 && glm::length(x) > 0.6; };
        expect_near(shell_thickness(1, 0.6, p, s), by_counting(inside, p, s, 2.1), 3e-4);
    }
}

TEST(TorusThickness, AcrossItsAxisIsFourTubeRadii) {
    expect_near(torus_thickness(2, 0.5, {2.5, 0, 0}, {-1, 0, 0}), {2, 1, 5}, 1e-13);
    expect_near(torus_thickness(2, 0.5, {2, 0, 0.5}, {0, 0, -1}), {1, 1, 1}, 1e-13);
    expect_near(torus_thickness(2, 0.5, {0, 0, 3}, {0, 0, -1}), {0, 0, 0}, 0);
}

TEST(TorusThickness, AgreesWithCounting) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi);
    auto inside = [](glm::dvec3 x) { return std::hypot(std::hypot(x.x, x.y) - 1, x.z) < 0.4; };
    for (int i = 0; i < 300; ++i) {
        const double u = angle(random), v = angle(random), rho = 1 + 0.4 * std::cos(v);
        const glm::dvec3 p{rho * std::cos(u), rho * std::sin(u), 0.4 * std::sin(v)};
        const auto s = random_direction(random);
        // A stretch shorter than a step may be missed by the counting, so `first` and `span` are
        // compared where the exact answer has none.
        const auto exact = torus_thickness(1, 0.4, p, s);
        const auto counted = by_counting(inside, p, s, 3);
        EXPECT_NEAR(exact.sum, counted.sum, 1e-3);
        if (exact.first == 0 || exact.first > 1e-3) {
            EXPECT_NEAR(exact.first, counted.first, 1e-3);
        }
        EXPECT_NEAR(exact.span, counted.span, 1e-3);
    }
}

TEST(TorusThickness, SurvivesEveryTangent) {
    // Over the top of the ring, along its rim and through its hole, a hair to either side.
    for (const double hair : {-1e-9, 0.0, 1e-9}) {
        const double graze = torus_thickness(1, 0.4, {-5, 0, 0.4 - hair}, {1, 0, 0}).sum;
        EXPECT_LE(graze, 2 * 2 * std::sqrt(2 * 0.4 * 1e-9) * 1.001); // two tubes, chord 2 sqrt(2rh)
        EXPECT_GE(graze, 0);
        const double rim = torus_thickness(1, 0.4, {-5, 1.4 - hair, 0}, {1, 0, 0}).sum;
        EXPECT_LE(rim, 2 * std::sqrt(2 * 1.4 * 1e-9) * 1.001);
        EXPECT_GE(rim, 0);
    }
}

TEST(SlabThickness, IsOverTheCosine) {
    for (const double cosine : {1.0, 0.9, 0.5, 0.3}) {
        const glm::dvec3 s{std::sqrt(1 - cosine * cosine), 0, -cosine};
        const double expected = 0.2 / cosine;
        expect_near(slab_thickness(10, 10, 0.2, {0, 0, 0.1}, s), {expected, expected, expected},
                    1e-14);
    }
}

TEST(SlabThickness, EndsAtTheSidesToo) {
    expect_near(slab_thickness(2, 4, 1, {0, 0, 0}, {1, 0, 0}), {1, 1, 1}, 1e-15);
    expect_near(slab_thickness(2, 4, 1, {-3, 0, 0}, {1, 0, 0}), {2, 0, 4}, 1e-15);
    expect_near(slab_thickness(2, 4, 1, {0, 0, 0.5}, {1, 0, 0}), {0, 0, 0}, 0); // along its face
}

TEST(BodyThickness, IsNothingBehindThePoint) {
    const glm::dvec3 p{0, 0, 5}, away{0, 0, 1};
    for (const auto& d : {sphere_thickness(1, p, away), shell_thickness(1, 0.5, p, away),
                          torus_thickness(1, 0.5, p, away), slab_thickness(1, 1, 1, p, away)})
        EXPECT_EQ(d.sum + d.first + d.span, 0);
}

} // namespace
