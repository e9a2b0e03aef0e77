// Pictures against scenes solved by thought, and against themselves.
#include "renderer/camera.h"
#include "renderer/geometry/bodies.h"
#include "renderer/materials.h"
#include "renderer/reference/convergence.h"
#include "renderer/reference/energy.h"
#include "renderer/reference/film_layers.h"
#include "renderer/reference/mesh_body.h"
#include "renderer/reference/path_tracer.h"
#include "tests/renderer/geometry/assembly.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>

namespace {

using namespace renderer::reference;
namespace geometry = renderer::geometry;

constexpr Boundary matched{}, smooth{BoundaryKind::Smooth}, rough{BoundaryKind::Rough, 0.4};

Picture picture_of(std::shared_ptr<const Body> body,
                   double diameter,
                   const Medium& medium,
                   const Illumination& illumination,
                   const Boundary& boundary = matched) {
    return {std::move(body), medium, boundary, illumination,
            renderer::frame(renderer::Millimetres{diameter}, {}, 1)};
}

Film film_after(const Picture& picture,
                int size,
                std::uint32_t batches,
                TracerTactics tactics = {},
                int log2_batch = 4) {
    Film film = blank_film(size, size, 1, log2_batch);
    for (std::uint32_t b = 0; b < batches; ++b)
        add_batch(picture, film, tactics);
    return film;
}

bool is_whole(const Film& film, std::size_t pixel) {
    return film.covered[pixel] == std::ldexp(static_cast<double>(film.batches), film.log2_batch);
}

/// Mean over whole pixels, with its standard error.
Estimate mean_of(const Film& film, std::size_t channel = 0) {
    double sum = 0, squares = 0, n = 0;
    for (std::size_t i = 0; i < film.sum.size(); ++i)
        if (is_whole(film, i)) {
            sum += mean(film, i)[channel];
            squares += std::pow(standard_error(film, i)[channel], 2);
            ++n;
        }
    return {sum / n, std::sqrt(squares) / n};
}

const Illumination even_sky{.sky = {1, 1, 1}};

Illumination sun_from(glm::dvec3 to_light, double half_angle_degrees = 0) {
    return {.suns = {
                {glm::normalize(to_light), {1, 1, 1}, renderer::from_degrees(half_angle_degrees)}}};
}

// Chandrasekhar's f(mu, mu0) of a half-space: seen straight on, the pixel's radiance is
// f(1, mu0) mu0 E.  The camera's field of view spreads mu over 1..0.966: seen through 0.2 degrees.
TEST(PathTracer, SeesAHalfSpaceAsChandrasekharDoes) {
    const std::shared_ptr<const Body> body = make_slab(std::numeric_limits<double>::infinity());
    for (const auto& [mu0, exact] : {std::pair{1.0, 0.122572307}, {0.5, 0.137453331 * 0.5}}) {
        auto picture = picture_of(body, 0.01, grey_medium(1, 0.9, 0, 1),
                                  sun_from({std::sqrt(1 - mu0 * mu0), 0, mu0}));
        picture.camera.clip_from_view[0][0] *= 100; // a hundredth of the field of view
        picture.camera.clip_from_view[1][1] *= 100;
        const auto seen = mean_of(film_after(picture, 12, 64));
        EXPECT_LE(std::abs(seen.value - exact), 4 * seen.standard_error) << mu0;
        EXPECT_LE(seen.standard_error, 2e-3 * exact);
    }
}

// A pure absorber is a matter of lengths: no noise at all where a pixel's chords are even.
TEST(PathTracer, SeesThroughAPureAbsorberByBeersLaw) {
    const std::shared_ptr<const Body> slab = make_slab(2);
    const Medium medium{{0.1, 0.5, 0}, {0, 0, 0}, 0, 1};
    auto picture = picture_of(slab, 0.01, medium, even_sky);
    picture.camera.clip_from_view[0][0] *= 1000;
    picture.camera.clip_from_view[1][1] *= 1000;
    const auto film = film_after(picture, 4, 2);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(mean_of(film, k).value, std::exp(-2 * medium.sigma_a[k]), 1e-7);
}

// Under an even sky a body that only scatters cannot be seen: every pixel is 1, within `limit`
// standard errors.
void expect_furnace(const Film& film, double limit) {
    std::size_t pixels = 0;
    double worst = 0;
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        if (!is_whole(film, i))
            continue;
        ++pixels;
        const auto m = mean(film, i), se = standard_error(film, i);
        for (std::size_t k = 0; k < 3; ++k)
            worst = std::max(worst, std::abs(m[k] - 1) / (se[k] + 1e-12));
    }
    ASSERT_GT(pixels, 20u);
    EXPECT_LE(worst, limit);
}

TEST(Furnace, HidesConcaveNestedAndColouredBodies) {
    const Medium coloured{{0, 0, 0}, {0.3, 2, 0}, 0.4, 1.4};
    for (const auto& boundary : {matched, smooth})
        for (const auto& mesh : {geometry::shell(1, 0.5, 3), geometry::torus(0.7, 0.3, 32, 16)}) {
            const auto picture = picture_of(make_mesh_body(mesh), 2, coloured, even_sky, boundary);
            const auto film = film_after(picture, 12, 64);
            // Student with 63 degrees of freedom: 6 standard errors are 1e-7 a pixel and channel
            expect_furnace(film, 6);
            EXPECT_EQ(film.leaks, 0u);
        }
}

// Light that facets hide from each other meets the surface again: none is lost.
TEST(Furnace, HidesARoughBody) {
    const auto picture = picture_of(make_sphere(1), 2, grey_medium(2, 1, 0, 1.4), even_sky, rough);
    EXPECT_NEAR(mean_of(film_after(picture, 12, 4)).value, 1, 1e-12);
}

// A wide sun is found by asking for it and by turning into it: both ways give the same light.
TEST(Sun, OfFiniteAngleIsFoundTheSameByAskingAndByTurning) {
    const Medium medium = grey_medium(1, 0.9, 0.8, 1);
    const auto body = std::shared_ptr<const Body>(make_sphere(1));
    const auto sun = sun_from({0.3, 0.2, -1}, 40);
    const auto asked = mean_of(film_after(picture_of(body, 2, medium, sun), 12, 64));
    // A rough boundary between equal indices is a matched one, whose kind the collector does not
    // connect through: only turning finds the sun.
    auto blind = picture_of(body, 2, medium, sun, smooth);
    blind.medium.index = 1 + 1e-12;
    const auto turned = mean_of(film_after(blind, 12, 64));
    EXPECT_LE(std::abs(asked.value - turned.value),
              4 * std::hypot(asked.standard_error, turned.standard_error));
    EXPECT_LT(asked.standard_error, turned.standard_error);
}

// Connections go through the rough surface; paths that turn into the disc find the same.
TEST(Sun, IsReachedThroughARoughBoundary) {
    const auto body = std::shared_ptr<const Body>(make_sphere(1));
    const auto sun = sun_from({0.5, 0.3, 1}, 20);
    const Medium medium = grey_medium(2, 0.9, 0, 1.4);
    const auto disc = mean_of(film_after(picture_of(body, 2, medium, sun, rough), 12, 64));
    const auto direction =
        mean_of(film_after(picture_of(body, 2, medium, sun_from({0.5, 0.3, 1}), rough), 12, 64));
    // The disc's mean direction is the direction: they differ by what 20 degrees blur, second
    // order.
    EXPECT_GT(direction.value, 0);
    EXPECT_LE(std::abs(disc.value - direction.value), 0.05 * direction.value);
}

// Far away a lamp is a sun; two lights are the sum of them.
TEST(Lamp, FarAwayIsASunAndLightsAdd) {
    const auto body = std::shared_ptr<const Body>(make_sphere(1));
    const Medium medium = grey_medium(2, 0.8, 0, 1);
    const glm::dvec3 side = glm::normalize(glm::dvec3(1, 0.5, 0.2));
    const Illumination sun = sun_from(side);
    const Illumination lamp{.lamps = {{1e4 * side, {0.25, 0.25, 0.25}, 2e4}}}; // 0.25 (2e4/1e4)^2
    Illumination both = sun;
    both.lamps = lamp.lamps;
    const auto one = mean_of(film_after(picture_of(body, 2, medium, sun), 8, 32));
    const auto other = mean_of(film_after(picture_of(body, 2, medium, lamp), 8, 32));
    const auto sum = mean_of(film_after(picture_of(body, 2, medium, both), 8, 32));
    EXPECT_NEAR(one.value, other.value, 1e-3 * one.value); // the same paths: lamp rays spread 1e-4
    EXPECT_NEAR(sum.value, one.value + other.value, 1e-6 * sum.value);
}

TEST(LightThreshold, ChangesNothingOnAverage) {
    const auto body = std::shared_ptr<const Body>(make_mesh_body(geometry::sphere(1, 4)));
    const auto grey = grey_medium(5, 0.9, 0, 1);
    const Medium coloured{{0.5, 0.1, 2}, {4.5, 1.9, 6}, 0, 1};
    for (const auto& medium : {grey, coloured}) {
        const auto picture = picture_of(body, 2, medium, sun_from({0, 0.3, -1}));
        const auto always = mean_of(film_after(picture, 12, 32, {.light_threshold = 0}));
        const auto seldom = mean_of(film_after(picture, 12, 32, {.light_threshold = 1}));
        EXPECT_LE(std::abs(always.value - seldom.value),
                  4 * std::hypot(always.standard_error, seldom.standard_error));
    }
}

// Four paths on each line of sight or one: the same picture.
TEST(SharedLines, ChangeNothingOnAverage) {
    const auto body =
        std::shared_ptr<const Body>(make_mesh_body(geometry::torus(0.7, 0.3, 24, 12)));
    const Medium medium{{0.5, 0.1, 2}, {4.5, 1.9, 6}, 0, 1};
    const auto picture = picture_of(body, 2, medium, sun_from({0, 0.3, -1}));
    const auto alone = mean_of(film_after(picture, 12, 32, {.share_lines = false}));
    const auto shared = mean_of(film_after(picture, 12, 32));
    EXPECT_LE(std::abs(alone.value - shared.value),
              4 * std::hypot(alone.standard_error, shared.standard_error));
}

bool same_bits(const Film& a, const Film& b) {
    return a.batches == b.batches &&
           std::memcmp(a.sum.data(), b.sum.data(), a.sum.size() * sizeof(a.sum[0])) == 0 &&
           std::memcmp(a.squares.data(), b.squares.data(), a.sum.size() * sizeof(a.sum[0])) == 0 &&
           std::memcmp(a.odd.data(), b.odd.data(), a.sum.size() * sizeof(a.sum[0])) == 0 &&
           a.covered == b.covered;
}

Picture study_like() {
    renderer::Scene scene;
    const auto mesh = geometry::torus(0.7, 0.3, 24, 12);
    scene.material = *renderer::measured_material("marble");
    scene.placement = renderer::place(geometry::bounding_sphere(mesh), {4}, {30, 20});
    scene.camera = renderer::frame({4}, {30, 20}, 1);
    scene.lights = {{renderer::DirectionalLight{glm::normalize(glm::dvec3(0.3, 0.2, -1))}}};
    return *picture_of_scene(mesh, scene);
}

TEST(PathTracer, GivesTheSameBitsForAnyNumberOfThreads) {
    const auto picture = study_like();
    const auto two = film_after(picture, 40, 2);
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const auto one = film_after(picture, 40, 2);
    EXPECT_TRUE(same_bits(one, two));
    EXPECT_GT(one.sum[40 * 20 + 10][0], 0);
}

TEST(Film, IsResumedFromItsLayersBitForBit) {
    const auto picture = study_like();
    auto film = film_after(picture, 16, 3);
    const auto restored = film_of(
        layers_of(film), {film.seed, film.log2_batch, film.batches, film.paths, film.leaks});
    ASSERT_TRUE(restored) << restored.error();
    EXPECT_TRUE(same_bits(film, *restored));
    auto resumed = *restored;
    add_batch(picture, film);
    add_batch(picture, resumed);
    EXPECT_TRUE(same_bits(film, resumed));
}

TEST(Film, WithoutItsSumsIsNamed) {
    auto layers = layers_of(film_after(study_like(), 8, 2));
    layers.layers.pop_back();
    const auto film = film_of(layers, {});
    ASSERT_FALSE(film);
    EXPECT_THAT(film.error(), testing::HasSubstr("has no channel odd.lower.B"));
}

TEST(Film, StandardErrorIsThatOfItsBatches) {
    Film film = blank_film(1, 1, 1);
    for (const double light : {1.0, 2.0, 4.0, 5.0}) {
        add(film, 0, {{light, 0, 7}, 16});
        ++film.batches;
    }
    EXPECT_DOUBLE_EQ(mean(film, 0)[0], 3);
    EXPECT_NEAR(standard_error(film, 0)[0], std::sqrt(10.0 / 3 / 4), 1e-15); // s^2 = 10 / 3
    EXPECT_EQ(standard_error(film, 0)[2], 0);
    EXPECT_EQ(halves(film).even.pixels[0].r, 2.5f);
    EXPECT_EQ(halves(film).odd.pixels[0].r, 3.5f);
}

// One batch in 25 met something bright: its light x stays, as x / 25 of the mean, and the standard
// error says that the pixel hangs on one batch: s^2 = x^2 / 25, over 25 batches x / 25, all of it.
TEST(Film, KeepsFirefliesAndReportsThemAsVariance) {
    constexpr double x = 1e4;
    constexpr std::uint32_t n = 25;
    Film film = blank_film(10, 10, 1);
    for (std::uint32_t b = 0; b < n; ++b) {
        for (std::size_t pixel = 0; pixel < 100; ++pixel) {
            const double even = b % 2 == 0 ? 1.001 : 0.999;
            add(film, pixel, {{even, even, even}, 16});
        }
        ++film.batches;
    }
    film.sum[42][0] += x;
    film.squares[42][0] += (1.001 + x) * (1.001 + x) - 1.001 * 1.001;

    EXPECT_NEAR(mean(film, 42)[0], 1 + x / n, 1e-3);
    EXPECT_NEAR(standard_error(film, 42)[0], x / n, 1e-3 * x / n);
    EXPECT_LE(standard_error(film, 42)[1], 1e-3);
    const auto layers = layers_of(film);
    const auto* light = renderer::imaging::find_layer(layers, "R");
    const auto* variance = renderer::imaging::find_layer(layers, "variance.R");
    ASSERT_TRUE(light != nullptr && variance != nullptr);
    EXPECT_NEAR(light->values[42], 1 + x / n, 1e-3);
    EXPECT_EQ(std::ranges::max_element(variance->values) - variance->values.begin(), 42);
    // and the picture is not called good for the 99 others
    std::vector<std::size_t> mask(100);
    std::iota(mask.begin(), mask.end(), 0u);
    const auto state = judge(film, mask, {});
    EXPECT_FALSE(state.converged);
    EXPECT_DOUBLE_EQ(state.good_share, 0.99);
}

// Neither what is no number nor light below zero, which chance can make of none, is ever sure.
TEST(Convergence, NeverCallsAPixelGoodThatIsNoNumberOrNegative) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -1.0}) {
        Film film = blank_film(1, 1, 1, 4);
        for (int b = 0; b < 16; ++b) {
            const double light = b % 2 == 0 ? bad : 0.5 * bad;
            add(film, 0, {{light, light, light}, 16});
            ++film.batches;
        }
        const auto state = judge(film, {0}, {});
        EXPECT_FALSE(state.converged);
        EXPECT_EQ(state.good_share, 0);
    }
}

TEST(Convergence, StopsWhenTheRuleIsMetAndSaysHowSure) {
    const auto picture = study_like();
    Film film = blank_film(12, 12, 1);
    StopRule rule{.relative = 0.2, .of_mean = 0.1};
    double last = 0;
    const auto outcome =
        render(picture, film, rule, {}, [&](const Progress& p) { last = p.fraction; });
    ASSERT_TRUE(outcome) << outcome.error();
    EXPECT_TRUE(outcome->state.converged);
    EXPECT_GE(outcome->state.good_share, rule.share);
    EXPECT_GE(film.batches, rule.least_batches);
    EXPECT_EQ(last, 1);
    // the error that is claimed is the one there is: two runs differ by sqrt(2) of it
    Film other = blank_film(12, 12, 2);
    ASSERT_TRUE(render(picture, other, rule));
    double z2 = 0, n = 0;
    for (std::size_t i = 0; i < film.sum.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (const double se =
                    std::hypot(standard_error(film, i)[k], standard_error(other, i)[k]);
                se > 0) {
                z2 += std::pow((mean(film, i)[k] - mean(other, i)[k]) / se, 2);
                ++n;
            }
    // t^2 of 30 degrees of freedom has mean 1.07; some 100 independent pixels: +-0.2
    EXPECT_NEAR(z2 / n, 1.07, 0.6);
}

TEST(Convergence, ReturnsTheBestSoFarWhenTimeIsUp) {
    Film film = blank_film(32, 32, 1);
    const StopRule rule{
        .relative = 1e-6, .of_mean = 1e-7, .time_budget = std::chrono::duration<double>(0.2)};
    const auto outcome = render(study_like(), film, rule);
    ASSERT_TRUE(outcome) << outcome.error();
    EXPECT_TRUE(outcome->out_of_time);
    EXPECT_FALSE(outcome->state.converged);
    EXPECT_GE(film.batches, 2u);
    EXPECT_GT(outcome->state.relative_error, 0);
}

// Light and eye may change places: a sphere's total towards one direction from another.
TEST(PathTracer, IsReciprocal) {
    const auto body = std::shared_ptr<const Body>(
        make_mesh_body(geometry::rounded_box({0.8, 0.5, 0.35}, 0.15, 8)));
    const auto a = glm::normalize(glm::dvec3(0.4, 0.3, 1)),
               b = glm::normalize(glm::dvec3(-1, 0.5, 0.2));
    const Medium medium = grey_medium(2, 0.9, 0.5, 1);
    const auto total = [&](glm::dvec3 eye, glm::dvec3 light) {
        Picture picture{body, medium, matched, sun_from(light), {}, {}};
        // an orthographic camera that sees all of the body
        const glm::dvec3 u = glm::normalize(glm::cross({0, 1, 0}, eye)), v = glm::cross(eye, u);
        picture.camera.view_from_world = glm::dmat4(glm::transpose(glm::dmat3(u, v, eye)));
        picture.camera.clip_from_view = glm::dmat4(1);
        picture.camera.clip_from_view[2][2] = -0.2;
        const auto film = film_after(picture, 24, 64);
        Estimate sum;
        for (std::size_t i = 0; i < film.sum.size(); ++i) {
            sum.value += mean(film, i)[0];
            sum.standard_error += std::pow(standard_error(film, i)[0], 2);
        }
        sum.standard_error = std::sqrt(sum.standard_error);
        return sum;
    };
    const auto there = total(a, b), back = total(b, a);
    EXPECT_LE(std::abs(there.value - back.value),
              4 * std::hypot(there.standard_error, back.standard_error));
    EXPECT_LE(there.standard_error, 0.01 * there.value);
}

TEST(StudyScene, RefusesASmoothBoundaryUnderADirection) {
    renderer::Scene scene;
    scene.material = *renderer::measured_material("marble");
    const auto picture = picture_of_scene(geometry::sphere(1, 2), scene, {.boundary = smooth});
    ASSERT_FALSE(picture);
    EXPECT_THAT(picture.error(), testing::HasSubstr("smooth"));
}

} // namespace
