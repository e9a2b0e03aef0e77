#include "renderer/geometry/bodies.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/directions.h"
#include "renderer/thickness/band_choice.h"
#include "renderer/thickness/thickness_field.h"

#include <glm/glm.hpp>

#include <cmath>

namespace {

using namespace renderer::thickness;
using namespace renderer::geometry;
using renderer::harmonics::evaluate;

/// A ring, traced: not convex, and every side of it loses differently.
const ThicknessField& ring_field() {
    static const ThicknessField field =
        compute_thickness_field(torus(1, 0.4, 24, 14), {.directions = 256}).value();
    return field;
}

const Mesh& ring() {
    static const Mesh mesh = torus(1, 0.4, 24, 14);
    return mesh;
}

const glm::dvec3 eye = glm::normalize(glm::dvec3(0.4, -1, 0.3));
const glm::dvec3 light = glm::normalize(glm::dvec3(-0.2, 1, 0.5));

std::vector<SeenLight> lit(double per_length) {
    return {{light, per_length}};
}

/// Thickness in `bands` bands under several lights, each vertex by itself.
std::vector<double>
seen(const ThicknessField& field, const std::vector<SeenLight>& lights, int bands) {
    std::vector<double> sums(field.energy.size()),
        y(static_cast<std::size_t>(field.bands * field.bands));
    for (const auto& [to_light, per_length] : lights) {
        evaluate(field.bands, to_light, y);
        for (std::size_t v = 0; v < sums.size(); ++v)
            sums[v] += per_length * reconstruct(field, v, y, bands);
    }
    return sums;
}

/// The same without bins: vertices weighed by a third of the triangles around them, those counted
/// whose bin faces the eye.
double rms_by_vertices(const std::vector<SeenLight>& lights, glm::dvec3 to_eye, int bands) {
    const auto& field = ring_field();
    const auto all = seen(field, lights, field.bands), few = seen(field, lights, bands);
    const auto normals = vertex_normals(ring());
    std::vector<double> areas(all.size());
    for (const auto& [a, b, c] : ring().triangles) {
        const auto& p = ring().positions;
        for (const auto corner : {a, b, c})
            areas[corner] += glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
    }
    double squares = 0, area = 0;
    const auto directions = renderer::harmonics::fibonacci_directions(32, 1).directions;
    for (std::size_t v = 0; v < all.size(); ++v) {
        std::size_t nearest = 0;
        for (std::size_t k = 1; k < 32; ++k)
            if (glm::dot(directions[k], normals[v]) > glm::dot(directions[nearest], normals[v]))
                nearest = k;
        if (glm::dot(field.normal_bins.bins[nearest].normal, to_eye) > 0) {
            squares += areas[v] * std::pow(all[v] - few[v], 2);
            area += areas[v];
        }
    }
    return std::sqrt(squares / area);
}

TEST(NormalBins, ShareOutTheWholeSurface) {
    const auto& bins = ring_field().normal_bins;
    ASSERT_EQ(bins.bins.size(), 32u);
    EXPECT_EQ(bins.bands, 5);
    double share = 0;
    for (const auto& bin : bins.bins) {
        share += bin.share;
        EXPECT_EQ(bin.moments.size(), 325u);
        EXPECT_NEAR(glm::length(bin.normal), bin.share > 0 ? 1 : 0, 1e-12);
    }
    EXPECT_NEAR(share, 1, 1e-9); // 336 vertices rounded to 2^-40
}

// y^T <c c^T> y is the mean of (c.y)^2, for any y.
TEST(NormalBins, HoldTheMeanSquareOfTheirVertices) {
    const Mesh one = sphere(1, 0); // 12 vertices, 12 bins
    std::vector<float> c;
    for (int i = 0; i < 12 * 4; ++i)
        c.push_back(static_cast<float>(std::sin(i)));
    const auto bins = bin_by_normal(one, c, 2);
    const std::vector<double> y{0.3, -0.7, 1.1, 0.2};
    double expected = 0, found = 0;
    for (std::size_t v = 0; v < 12; ++v) {
        double dot = 0;
        for (std::size_t i = 0; i < 4; ++i)
            dot += static_cast<double>(c[4 * v + i]) * y[i];
        expected += dot * dot / 12;
    }
    for (const auto& bin : bins.bins)
        found += bin.share * mean_square(bin, y);
    EXPECT_NEAR(found, expected, 1e-9); // shares are rounded to 2^-40
}

// The prediction is not an estimate: it is the change itself, up to shares of 2^-40.
TEST(BandChoice, PredictsTheChangeExactly) {
    for (int n = 1; n <= 5; ++n)
        for (const auto& to_eye : {eye, -eye, light}) {
            const double truth = rms_by_vertices(lit(1), to_eye, n);
            EXPECT_NEAR(dropped_rms(ring_field().normal_bins, lit(1), to_eye, n), truth,
                        1e-7 + 1e-6 * truth);
        }
}

TEST(BandChoice, SeesSeveralLightsTogether) {
    const std::vector<SeenLight> lights{{light, 0.7}, {-eye, 0.4}, {{0, 0, 1}, 1.3}};
    const double truth = rms_by_vertices(lights, eye, 2);
    EXPECT_GT(truth, 0.01);
    EXPECT_NEAR(dropped_rms(ring_field().normal_bins, lights, eye, 2), truth, 1e-6 * truth);
}

TEST(BandChoice, OfEqualLightsIsThatOfOneStrongerLight) {
    const auto& bins = ring_field().normal_bins;
    const std::vector<SeenLight> five(5, SeenLight{light, 0.2});
    for (int n = 1; n < 5; ++n)
        EXPECT_NEAR(dropped_rms(bins, five, eye, n), dropped_rms(bins, lit(1), eye, n), 1e-12);
}

TEST(BandChoice, NeedsNoFewerBandsForLess) {
    const auto& bins = ring_field().normal_bins;
    const auto choice = choose_bands(bins, lit(1), eye, 0.02);
    ASSERT_EQ(choice.predicted.size(), 5u);
    EXPECT_EQ(choice.predicted.back(), 0);
    int before = 5;
    for (const double tolerance : {0.0, 1e-3, 1e-2, 3e-2, 0.1, 1.0, 10.0}) {
        const auto chosen = choose_bands(bins, lit(1), eye, tolerance);
        EXPECT_LE(chosen.bands, before);
        EXPECT_LE(chosen.predicted[static_cast<std::size_t>(chosen.bands - 1)], tolerance);
        if (chosen.bands > 1) {
            EXPECT_GT(chosen.predicted[static_cast<std::size_t>(chosen.bands - 2)], tolerance);
        }
        before = chosen.bands;
    }
    EXPECT_EQ(before, 1);
}

TEST(BandChoice, FollowsHowMuchTheLightCounts) {
    const auto& bins = ring_field().normal_bins;
    EXPECT_EQ(choose_bands(bins, lit(0), eye, 0).bands, 1); // a light that is off
    EXPECT_EQ(choose_bands(bins, lit(100), eye, 0.004).bands, 5);
}

// A light that moves to and fro about the limit by less than 5 % leaves the choice alone.
TEST(BandChoice, DoesNotFlickerAtTheLimit) {
    const auto& bins = ring_field().normal_bins;
    const double limit = choose_bands(bins, lit(1), eye, 1).predicted[2]; // of 3 bands
    EXPECT_EQ(choose_bands(bins, lit(1.001), eye, limit).bands, 4);
    const auto held = choose_bands(bins, lit(0.97), eye, limit, 4);
    EXPECT_EQ(held.bands, 4);
    EXPECT_EQ(held.rule, BandRule::Held);
    EXPECT_EQ(choose_bands(bins, lit(0.97), eye, limit, 3).bands, 3); // from below
    EXPECT_EQ(choose_bands(bins, lit(0.94), eye, limit, 4).bands, 3);
    EXPECT_EQ(choose_bands(bins, lit(1.001), eye, limit, 3).bands, 4); // up at once
}

TEST(BandChoice, SaysWhichRuleDecided) {
    const auto& bins = ring_field().normal_bins;
    const auto few = choose_bands(bins, lit(1), eye, 1);
    EXPECT_EQ(few.rule, BandRule::WithinTolerance);
    EXPECT_THAT(describe(few, 1), testing::HasSubstr("of 5 bands: the others change"));
    const auto all = choose_bands(bins, lit(1), eye, 0);
    EXPECT_EQ(all.rule, BandRule::Everything);
    EXPECT_THAT(describe(all, 0), testing::StartsWith("all 5 bands: one less changes"));
    EXPECT_EQ(describe(paper_bands({0, 0, 1}, {0, 0, -1}, 5), 0),
              "5 bands: the light is behind the object");
}

TEST(PaperPreset, TakesFiveBandsBehindAndTwoInFront) {
    EXPECT_EQ(paper_bands({0, 0, 1}, {0, 0, -1}, 5).bands, 5); // exactly opposite
    EXPECT_EQ(paper_bands({0, 0, 1}, {0, 0, 1}, 5).bands, 2);
    EXPECT_EQ(paper_bands({0, 0, 1}, {0, 0, -1}, 3).bands, 3);
    EXPECT_EQ(paper_bands({0, 0, 1}, {1, 0, 0}, 5).bands, 2); // L.V = 0 is in front
    EXPECT_EQ(paper_bands({0, 0, 1}, {0, 0, -1}, 5).rule, BandRule::PaperBehind);
    EXPECT_EQ(paper_bands({0, 0, 1}, {0, 0, 1}, 5).rule, BandRule::PaperInFront);
}

glm::dvec3 at_cosine(double x) {
    return {std::sqrt(1 - x * x), 0, x};
}

TEST(PaperPreset, ChangesOnlyPastItsDeadZone) {
    const glm::dvec3 to_eye{0, 0, 1};
    int bands = 2;
    for (const auto& [cosine, expected] : std::vector<std::pair<double, int>>{{0.04, 2},
                                                                              {-0.04, 2},
                                                                              {-0.049, 2},
                                                                              {-0.051, 5},
                                                                              {-0.01, 5},
                                                                              {0.049, 5},
                                                                              {0.051, 2},
                                                                              {-0.04, 2}}) {
        bands = paper_bands(at_cosine(cosine), to_eye, 5, bands).bands;
        EXPECT_EQ(bands, expected) << cosine;
    }
}

TEST(BandChoiceDeathTest, RefusesLightsWithoutALength) {
    const auto& bins = ring_field().normal_bins;
    EXPECT_DEATH(choose_bands(bins, std::vector<SeenLight>(1), eye, 0.1), "is_unit");
    EXPECT_DEATH(choose_bands(bins, lit(1), {0, 0, 2}, 0.1), "is_unit");
    EXPECT_DEATH(dropped_rms(bins, lit(1), eye, 6), "bands");
}

} // namespace
