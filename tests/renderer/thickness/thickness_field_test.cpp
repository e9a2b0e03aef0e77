#include "renderer/geometry/bodies.h"
#include "renderer/geometry/body_thickness.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/directions.h"
#include "renderer/thickness/bands.h"
#include "renderer/thickness/thickness_field.h"
#include "tests/renderer/geometry/assembly.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace {

using namespace renderer::thickness;
using namespace renderer::geometry;
using renderer::harmonics::fibonacci_directions;
using renderer::harmonics::flat_index;
using std::numbers::pi;

ThicknessField field_of(const Mesh& mesh, const FieldOptions& options) {
    auto field = compute_thickness_field(mesh, options);
    EXPECT_TRUE(field) << field.error();
    return field.value_or(ThicknessField{});
}

std::vector<double> traced(const Mesh& mesh, Kind kind, const std::vector<glm::dvec3>& directions) {
    auto lengths = trace_thickness(mesh, kind, directions);
    EXPECT_TRUE(lengths) << lengths.error();
    return lengths.value_or(std::vector<double>{});
}

std::vector<double> basis_at(int bands, glm::dvec3 s) {
    std::vector<double> y(static_cast<std::size_t>(bands * bands));
    renderer::harmonics::evaluate(bands, s, y);
    return y;
}

Mesh transformed(Mesh mesh, const glm::dmat3& by, glm::dvec3 then = {}) {
    for (auto& p : mesh.positions)
        p = by * p + then;
    return mesh;
}

/// Nothing about it is symmetric, and it is not convex.
Mesh crooked_body() {
    Mesh mesh = torus(1, 0.4, 24, 14);
    for (auto& p : mesh.positions)
        p = {1.3 * p.x + 0.2 * p.y * p.y, p.y, 0.8 * p.z + 0.3 * p.x * p.x};
    return mesh;
}

float largest(const std::vector<float>& values) {
    float most = 0;
    for (const float value : values)
        most = std::max(most, std::abs(value));
    return most;
}

// ---- closed forms through the whole chain

// Every vertex of a sphere sees the same about its own normal.  These are its coefficients about
// that normal, sum over m of y_lm(N) c_lm, less the closed form.
struct ZonalErrors {
    std::array<double, 6> mean{}, largest{};
};

ZonalErrors zonal_errors(const Mesh& mesh, const ThicknessField& field) {
    const std::array<double, 6> truth{1.7724539, -2.0466534, 0.9908318, 0, -0.2215567, 0};
    ZonalErrors errors;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const auto y = basis_at(6, mesh.positions[v]);
        for (int l = 0; l < 6; ++l) {
            const auto band = static_cast<std::size_t>(l);
            double zonal = 0;
            for (int m = -l; m <= l; ++m) {
                const auto i = static_cast<std::size_t>(flat_index(l, m));
                zonal += field.coefficients[v * 36 + i] * y[i];
            }
            const double error = std::sqrt(4 * pi / (2 * l + 1)) * zonal - truth[band];
            errors.mean[band] += error / static_cast<double>(mesh.positions.size());
            errors.largest[band] = std::max(errors.largest[band], std::abs(error));
        }
    }
    return errors;
}

// A facet lies a mean of h^2/16 below the sphere, more by 1/x along a ray that leaves at cosine x,
// and rays within h/2 of the tangent plane pass above it.  Over all directions that is of order h^2
// log(1/h): 0.006 in a coefficient of 1.8 at 4 subdivisions (h = 0.08).  Single vertices add the
// quadrature of 1024 directions, 0.04 % of 2.9.
TEST(ThicknessField, OfASphereTendsToTheCoefficientsOfTheClampedCosine) {
    const Mesh coarse = sphere(1, 3), fine = sphere(1, 4);
    const auto coarse_field = field_of(coarse, {.bands = 6}), field = field_of(fine, {.bands = 6});
    const auto before = zonal_errors(coarse, coarse_field), now = zonal_errors(fine, field);
    for (std::size_t l = 0; l < 6; ++l) {
        EXPECT_LE(std::abs(now.mean[l]), 0.008) << l;
        EXPECT_LE(now.largest[l], 0.01) << l;
        const double gain = before.mean[l] / now.mean[l]; // 4 less the logarithm
        EXPECT_GE(gain, 3) << l;
        EXPECT_LE(gain, 4.8) << l;
    }
}

TEST(ThicknessField, OfASphereHasItsEnergyAndItsPercentile) {
    const Mesh mesh = sphere(1, 4);
    const auto field = field_of(mesh, {});
    double energy = 0, rms = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        energy += field.energy[v] / static_cast<double>(mesh.positions.size());
        rms += truncation_rms(field, v, 5) / static_cast<double>(mesh.positions.size());
    }
    EXPECT_NEAR(energy, 8 * pi / 3, 0.025); // 0.15 % short in length, twice that in its square
    EXPECT_NEAR(energy_kept(field, 2), 0.8750, 0.003); // the part of the missing length, as above
    EXPECT_NEAR(energy_kept(field, 3), 0.9922, 0.001);
    EXPECT_NEAR(energy_kept(field, 5), 0.9980, 0.0005);
    EXPECT_NEAR(rms, 0.03608, 0.004); // facets add (0.015)^2 to the square
    // d = 2 (-x)+ with x uniform: lengths are uniform between 0 and 2
    EXPECT_NEAR(field.d_n, 0.995 * 2, 0.002);
    EXPECT_EQ(field.statistics.rays, mesh.positions.size() * 1024);
    EXPECT_EQ(field.statistics.fallbacks, 0u);
}

TEST(ThicknessField, KindsOnAShellFromThePole) {
    const Mesh mesh = shell(1, 0.5, 3);
    const glm::dvec3 pole = mesh.positions[0]; // on the outer sphere, its antipode is a vertex too
    ASSERT_NEAR(glm::length(pole), 1, 1e-12);
    EXPECT_NEAR(traced(mesh, Kind::Sum, {-pole})[0], 1.0, 4e-5); // jittered at vertices: 1e-5 rad
    EXPECT_NEAR(traced(mesh, Kind::First, {-pole})[0], 0.5, 4e-5);
    EXPECT_NEAR(traced(mesh, Kind::Span, {-pole})[0], 2.0, 4e-5);
}

TEST(ThicknessField, OfASlabIsItsThicknessOverTheCosine) {
    const Mesh mesh = slab(20, 20, 1, 8);
    const auto s = glm::normalize(glm::dvec3(0.3, -0.2, -1));
    const auto lengths = traced(mesh, Kind::Sum, {s});
    int seen = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (const auto& p = mesh.positions[v]; std::max(std::abs(p.x), std::abs(p.y)) < 9) {
            EXPECT_NEAR(lengths[v], p.z > 0 ? 1 / -s.z : 0, 3e-5); // 1e-6 of the diameter
            ++seen;
        }
    EXPECT_GT(seen, 50);
}

// Facets lie 0.0005 deep in the mean on the unit sphere, stretched by 1.5 and over the cosine:
// 0.003.
TEST(ThicknessField, OfAnEllipsoidFollowsItsFormula) {
    const glm::dvec3 axes(1.5, 1, 0.7);
    const Mesh mesh =
        transformed(sphere(1, 4), glm::dmat3(axes.x, 0, 0, 0, axes.y, 0, 0, 0, axes.z));
    const auto directions = fibonacci_directions(30, 4).directions;
    const auto lengths = traced(mesh, Kind::Sum, directions);
    double worst_mean = 0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        double mean = 0;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            mean += std::abs(lengths[v * directions.size() + k] -
                             ellipsoid_thickness(axes, mesh.positions[v], directions[k]).sum);
        worst_mean = std::max(worst_mean, mean / static_cast<double>(mesh.positions.size()));
    }
    EXPECT_LE(worst_mean, 0.004);
    EXPECT_GT(worst_mean, 0);
}

TEST(ThicknessField, OfTwoSpheresIsTheSumOfTwoChords) {
    const glm::dvec3 apart(3, 0, 0);
    const Mesh mesh = together(sphere(1, 4), sphere(0.5, 4), apart);
    const glm::dvec3 s = glm::normalize(glm::dvec3(1, 0.03, 0.02));
    const auto sum = traced(mesh, Kind::Sum, {s}), span = traced(mesh, Kind::Span, {s});
    int both = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const auto p = mesh.positions[v];
        const double first = sphere_thickness(1, p, s).sum,
                     second = sphere_thickness(0.5, p - apart, s).sum;
        if (p.x < -0.8 && second > 0.8) { // steep through both: facets lie 8e-4 deep at most
            EXPECT_NEAR(sum[v], first + second, 0.006);
            EXPECT_NEAR(span[v], sphere_thickness(0.5, p - apart, s).span, 0.004);
            EXPECT_GT(span[v], sum[v] + 1); // the gap
            ++both;
        }
    }
    EXPECT_GT(both, 20);
}

// A cavity whose triangles face outward encloses twice: it is solid, as overlapping bodies are.
TEST(ThicknessField, NestedBodiesCountOnce) {
    const Mesh solid = together(sphere(1, 3), sphere(0.5, 2), {});
    const Mesh hollow = together(sphere(1, 3), flipped(sphere(0.5, 2)), {});
    const glm::dvec3 pole = solid.positions[0];
    EXPECT_NEAR(traced(solid, Kind::Sum, {-pole})[0], 2, 1e-4);
    EXPECT_NEAR(traced(hollow, Kind::Sum, {-pole})[0], 1, 1e-4);
    const auto field = field_of(solid, {.bands = 2, .directions = 64});
    EXPECT_EQ(field.statistics.fallbacks, 0u);
}

TEST(ThicknessField, OneBandIsTheMeanThickness) {
    const Mesh mesh = sphere(1, 3);
    const auto field = field_of(mesh, {.bands = 1, .directions = 256});
    ASSERT_EQ(field.coefficients.size(), mesh.positions.size());
    const auto y = basis_at(1, {0, 0, 1});
    // the mean of 2(-x)+ over the sphere is 1/2; at 3 subdivisions 0.0254/1.77 of it is missing
    EXPECT_NEAR(reconstruct(field, 5, y, 1), 0.5, 0.01);
}

TEST(ThicknessField, AThinShellKeepsLittleEnergyInFiveBands) {
    const Mesh mesh = shell(1, 0.99, 3);
    // 1e-2 of the size against facets 3e-3 deep: the numbers are those of the mesh, not of the body
    const auto field = field_of(mesh, {.bands = 5, .directions = 256});
    EXPECT_LT(energy_kept(field, 5), 0.7);
    EXPECT_GT(energy_kept(field, 5), 0.4);
    EXPECT_EQ(field.statistics.fallbacks, 0u);
}

// Two slabs' faces a ten-thousandth of the diameter apart.
TEST(ThicknessField, AThinSheetIsRightToOnePercent) {
    const Mesh mesh = slab(1, 1, 1.4e-4, 4);
    const auto s = glm::normalize(glm::dvec3(0.2, 0.1, -1));
    const auto lengths = traced(mesh, Kind::Sum, {s});
    int seen = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (const auto& p = mesh.positions[v];
            p.z > 0 && std::max(std::abs(p.x), std::abs(p.y)) < 0.49) {
            EXPECT_NEAR(lengths[v], 1.4e-4 / -s.z, 1.4e-6);
            ++seen;
        }
    EXPECT_GT(seen, 5);
}

// ---- what must not change the answer

TEST(ThicknessField, DoesNotDependOnTheNumberOfThreads) {
    const Mesh mesh = sphere(1, 4); // 2562 vertices: 6 blocks
    const FieldOptions options{.bands = 4, .directions = 64};
    ThicknessField alone, shared;
    tbb::task_arena(1).execute([&] { alone = field_of(mesh, options); });
    tbb::task_arena(2).execute([&] { shared = field_of(mesh, options); });
    EXPECT_EQ(alone.coefficients, shared.coefficients);
    EXPECT_EQ(alone.energy, shared.energy);
    EXPECT_EQ(alone.d_n, shared.d_n);
    EXPECT_EQ(alone.percentiles, shared.percentiles);
    EXPECT_EQ(alone.normal_bins, shared.normal_bins);
    EXPECT_EQ(alone.statistics.retried, shared.statistics.retried);
}

TEST(ThicknessField, ScalesWithTheModel) {
    const Mesh mesh = crooked_body();
    const FieldOptions options{.bands = 3, .directions = 64};
    const auto field = field_of(mesh, options);
    for (const double k : {1e-6, 1e6, 1.7}) {
        const auto scaled = field_of(transformed(mesh, glm::dmat3(k)), options);
        ASSERT_EQ(scaled.coefficients.size(), field.coefficients.size());
        const double tolerance = 1e-6 * largest(field.coefficients);
        for (std::size_t i = 0; i < field.coefficients.size(); ++i)
            EXPECT_NEAR(scaled.coefficients[i] / k, field.coefficients[i], tolerance);
        EXPECT_NEAR(scaled.d_n / k, field.d_n, 1e-5 * field.d_n);
    }
}

TEST(ThicknessField, IsTheSameFarFromTheOrigin) {
    const Mesh mesh = crooked_body();
    const FieldOptions options{.bands = 3, .directions = 64};
    const auto field = field_of(mesh, options);
    const auto far = field_of(transformed(mesh, glm::dmat3(1), {1e6, -1e6, 1e6}), options);
    // the spacing of doubles at 1e6 is 1e-10, so floats of the recentred mesh differ by an ulp at
    // most
    const double tolerance = 1e-6 * largest(field.coefficients);
    for (std::size_t i = 0; i < field.coefficients.size(); ++i)
        EXPECT_NEAR(far.coefficients[i], field.coefficients[i], tolerance);
}

TEST(ThicknessField, DoesNotDependOnTheOrderOfTrianglesAndVertices) {
    const Mesh mesh = crooked_body();
    const FieldOptions options{.bands = 3, .directions = 64};
    const auto field = field_of(mesh, options);

    std::mt19937 random(3);
    std::vector<std::uint32_t> new_index(mesh.positions.size());
    std::iota(new_index.begin(), new_index.end(), 0u);
    std::shuffle(new_index.begin(), new_index.end(), random);
    Mesh shuffled = mesh;
    for (std::size_t v = 0; v < new_index.size(); ++v)
        shuffled.positions[new_index[v]] = mesh.positions[v];
    for (auto& [a, b, c] : shuffled.triangles) {
        const auto before = std::array{a, b, c};
        a = new_index[before[1]];
        b = new_index[before[2]];
        c = new_index[before[0]];
    }
    std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);

    const auto again = field_of(shuffled, options);
    const double tolerance = 1e-6 * largest(field.coefficients);
    for (std::size_t v = 0; v < new_index.size(); ++v)
        for (std::size_t i = 0; i < 9; ++i)
            EXPECT_NEAR(again.coefficients[new_index[v] * 9 + i], field.coefficients[v * 9 + i],
                        tolerance);
}

// Turning body and light together leaves the length, up to the quadrature: 1024 directions place a
// silhouette of the body to within a few percent of one band's amplitude.
TEST(ThicknessField, TurnsWithTheBody) {
    const Mesh mesh = crooked_body();
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1), 1.1, glm::normalize(glm::dvec3(1, 2, -1))));
    const auto field = field_of(mesh, {}), turned = field_of(transformed(mesh, turn), {});
    double squares = 0, difference = 0;
    for (const auto& light : fibonacci_directions(10, 8).directions) {
        const auto y = basis_at(5, light), y_turned = basis_at(5, turn * light);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const double d = reconstruct(field, v, y, 5);
            squares += d * d;
            difference += std::pow(reconstruct(turned, v, y_turned, 5) - d, 2);
        }
    }
    EXPECT_LE(std::sqrt(difference / squares), 0.01);
}

// The coefficients are a least-squares fit of what trace_thickness says.
TEST(ThicknessField, IsTheFitOfTheTracedLengths) {
    const Mesh mesh = crooked_body();
    const auto field = field_of(mesh, {.bands = 6, .directions = 512});
    const auto directions = fibonacci_directions(512, 1).directions;
    const auto lengths = traced(mesh, Kind::Sum, directions);
    double error = 0, bound = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        for (std::size_t k = 0; k < directions.size(); ++k)
            error += std::pow(reconstruct(field, v, basis_at(6, directions[k]), 6) -
                                  lengths[v * directions.size() + k],
                              2) /
                     512;
        bound += std::pow(truncation_rms(field, v, 6), 2);
    }
    // the residual of the fit is the energy that is not in the bands, up to the quadrature of y^2
    EXPECT_NEAR(error / bound, 1, 0.02);
}

TEST(ThicknessField, ReportsItsProgress) {
    std::vector<double> fractions;
    const auto field =
        compute_thickness_field(sphere(1, 4), {.bands = 1, .directions = 8},
                                [&](double fraction) { fractions.push_back(fraction); });
    ASSERT_TRUE(field);
    EXPECT_EQ(fractions.size(), 6u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1);
}

// Stopped from the progress of the first block: the other five are never heard of.
TEST(ThicknessField, StopsWhenAskedTo) {
    std::stop_source stop;
    int reports = 0;
    const auto field = compute_thickness_field(
        sphere(1, 4), {.bands = 1, .directions = 64},
        [&](double) {
            ++reports;
            stop.request_stop();
        },
        stop.get_token());
    ASSERT_FALSE(field);
    EXPECT_EQ(field.error(), "cancelled before all rays were traced");
    EXPECT_EQ(reports, 1);
}

// Of a sphere lengths are uniform between 0 and 2, and percentiles their fractions.  Of the mesh
// the shortest are missing: rays within half an edge (h = 0.08) of the tangent plane pass above it,
// so that lengths begin at 2 * 0.04.
TEST(ThicknessField, KeepsItsPercentilesAndItsBounds) {
    const auto field = field_of(sphere(1, 4), {});
    ASSERT_EQ(field.percentiles.size(), 6u);
    for (const auto& [fraction, length] : field.percentiles)
        EXPECT_NEAR(length, 2 * (0.04 + 0.96 * fraction), 0.004) << fraction; // facets, bins
    EXPECT_NEAR(field.bounds.radius, 1, 1e-12);
    EXPECT_EQ(field.options, FieldOptions{});
}

TEST(ThicknessFieldDeathTest, RefusesBandsOutOfRange) {
    EXPECT_DEATH((void)compute_thickness_field(sphere(1, 0), {.bands = 7}), "bands");
    EXPECT_DEATH((void)compute_thickness_field(sphere(1, 0), {.bands = 0}), "bands");
}

} // namespace
