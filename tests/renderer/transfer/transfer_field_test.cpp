#include "renderer/diffusion/fresnel.h"
#include "renderer/geometry/bodies.h"
#include "renderer/harmonics/basis.h"
#include "renderer/materials.h"
#include "renderer/transfer/transfer_field.h"

#include <glm/geometric.hpp>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace renderer::transfer;
using renderer::Medium;
using renderer::diffusion::dipoles;
using renderer::diffusion::PointTree;
using renderer::diffusion::vertex_samples;
using renderer::geometry::Mesh;
using renderer::geometry::sphere;
using renderer::harmonics::flat_index;
using std::numbers::pi;

const Medium plain{{0.1, 0.1, 0.1}, {1, 1, 1}, 1};

// The clamped cosine's zonal expansion.
const std::array<double, 5> clamped_cosine{pi, 2 * pi / 3, pi / 4, 0, -pi / 24};

std::vector<double> basis_at(int bands, glm::dvec3 s) {
    std::vector<double> y(static_cast<std::size_t>(bands * bands));
    renderer::harmonics::evaluate(bands, s, y);
    return y;
}

TransferField field_of(const Mesh& mesh, const Medium& medium, const TransferOptions& options) {
    auto field = compute_transfer_field(mesh, medium, 1, options);
    EXPECT_TRUE(field) << field.error();
    return field.value_or(TransferField{});
}

/// Largest distance of transfer vectors (per channel) from scale_l y_lm(N), over y_0 scale_0.
double zonal_error(const Mesh& mesh,
                   const std::vector<float>& transfer,
                   std::size_t channel,
                   const std::array<double, 5>& scale) {
    double worst = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const auto y = basis_at(5, glm::normalize(mesh.positions[v]));
        for (int l = 0; l < 5; ++l)
            for (int m = -l; m <= l; ++m) {
                const auto i = static_cast<std::size_t>(flat_index(l, m));
                const double t = static_cast<double>(transfer[(3 * v + channel) * 25 + i]);
                worst = std::max(worst, std::abs(t - scale[static_cast<std::size_t>(l)] * y[i]));
            }
    }
    return worst / (scale[0] * 0.2820947918);
}

// t_lm = (1/pi) lambda_l A_l y_lm(N), exact on a sphere that shadows nothing; lambda as tabulated.
TEST(TransferField, SphereHasTheTabulatedEigenvalues) {
    const std::array<double, 5> lambda{0.4036307, 0.3677802, 0.3168077, 0.2649049, 0.2184155};
    const auto mesh = sphere(5, 4);
    const auto field = field_of(mesh, plain, {});
    std::array<double, 5> scale{};
    for (std::size_t l = 0; l < 5; ++l)
        scale[l] = lambda[l] * clamped_cosine[l] / pi;
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_LE(zonal_error(mesh, field.transfer, c, scale), 0.01) << c;
}

// The table's second row has the boundary in the kernel (exact A of 1.3) but not before it (Ft =
// 1).
TEST(TransferField, SphereOfSkinHasTheTabulatedEigenvalues) {
    const std::array<double, 5> lambda{0.4217585, 0.3252988, 0.2449735, 0.1864068, 0.1432735};
    const auto mesh = sphere(5, 4);
    const auto samples = vertex_samples(mesh);
    const auto irradiance = irradiance_transfer(mesh, samples, 1, {});
    const auto kernels = dipoles(renderer::measured_medium("skin1").value());
    const auto transfer = renderer::diffusion::spread(PointTree(samples, irradiance, 25), kernels,
                                                      mesh.positions, 0.01);
    std::array<double, 5> scale{};
    for (std::size_t l = 0; l < 5; ++l)
        scale[l] = lambda[l] * clamped_cosine[l];
    EXPECT_LE(zonal_error(mesh, transfer, 0, scale), 0.01);
}

TEST(TransferField, ShadowedDiffuseSphereIsTheClampedCosine) {
    const auto mesh = sphere(5, 4);
    const auto field = field_of(mesh, plain, {.mode = Mode::ShadowedDiffuse});
    std::array<double, 5> scale{};
    for (std::size_t l = 0; l < 5; ++l)
        scale[l] = 0.4040250 * clamped_cosine[l] / pi; // albedo: the plane total
    EXPECT_LE(zonal_error(mesh, field.transfer, 0, scale), 0.01);
}

// A light of five bands is not a point: a facing Lambert patch leaves 31/32 of what it should, and
// 17/16 with three; opposite to the light it dips below zero.
TEST(TransferField, FiveBandsPeakAtThirtyOneThirtySeconds) {
    const auto mesh = sphere(5, 4);
    for (const auto& [bands, peak] : {std::pair{5, 31.0 / 32}, std::pair{3, 17.0 / 16}}) {
        const auto field = field_of(mesh, plain, {.mode = Mode::ShadowedDiffuse, .bands = bands});
        const auto facing = basis_at(bands, glm::normalize(mesh.positions[7]));
        EXPECT_NEAR(exit_radiance(field, 7, facing).x * pi / 0.4040250, peak, 0.01) << bands;
    }
    const auto field = field_of(mesh, plain, {.mode = Mode::ShadowedDiffuse});
    double lowest = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        lowest = std::min(lowest, exit_radiance(field, v, basis_at(5, {0, 0, 1})).x);
    EXPECT_NEAR(lowest * pi / 0.4040250, -0.031, 0.005);
}

// Under the same light from everywhere, irradiance below the boundary is pi (1 - F_ext).
TEST(TransferField, TheBoundaryTakesItsDiffuseShare) {
    const auto mesh = sphere(5, 3);
    const auto samples = vertex_samples(mesh);
    const auto irradiance = irradiance_transfer(mesh, samples, 1.5, {.directions = 4096});
    const double expected = pi * (1 - 0.0917780) * 0.2820947918;
    for (std::size_t v = 0; v < samples.positions.size(); ++v)
        ASSERT_NEAR(static_cast<double>(irradiance[25 * v]) / expected, 1, 0.01);
}

TEST(TransferField, TheInsideOfARingIsDarker) {
    const auto mesh = renderer::geometry::torus(5, 2, 48, 24);
    const auto samples = vertex_samples(mesh);
    const auto irradiance = irradiance_transfer(mesh, samples, 1, {});
    double inner = 0, outer = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const double around = std::hypot(mesh.positions[v].x, mesh.positions[v].y);
        if (around < 3.001)
            inner = static_cast<double>(irradiance[25 * v]);
        if (around > 6.999)
            outer = static_cast<double>(irradiance[25 * v]);
    }
    EXPECT_NEAR(outer / (pi * 0.2820947918), 1, 0.02); // convex there: sees everything
    EXPECT_GT(inner, 0.2 * outer);
    EXPECT_LT(inner, 0.9 * outer);
}

TEST(TransferField, DoesNotDependOnTheNumberOfThreads) {
    const auto mesh = renderer::geometry::torus(5, 2, 30, 15); // coarse: points are drawn
    const auto run = [&](int threads) {
        TransferField field;
        tbb::task_arena arena(threads);
        arena.execute([&] { field = field_of(mesh, plain, {.directions = 128}); });
        return field.transfer;
    };
    EXPECT_EQ(run(1), run(4));
}

TEST(TransferField, OnlyMillimetresCount) {
    const auto mm = compute_transfer_field(sphere(5, 2), plain, 1, {.directions = 128});
    // a power of two: nothing is rounded differently, and the same samples are drawn
    const auto large =
        compute_transfer_field(sphere(5.0 / 1024, 2), plain, 1024, {.directions = 128});
    ASSERT_TRUE(mm && large);
    const float scale = *std::max_element(mm->transfer.begin(), mm->transfer.end());
    for (std::size_t i = 0; i < mm->transfer.size(); ++i)
        ASSERT_NEAR(mm->transfer[i], large->transfer[i], 1e-5F * scale);
}

TEST(TransferField, SaysWhenItIsUndersampled) {
    const auto mesh = sphere(5, 1);
    EXPECT_FALSE(field_of(mesh, plain, {.directions = 64}).undersampled);
    EXPECT_TRUE(field_of(mesh, plain, {.directions = 64, .most_samples = 50}).undersampled);
}

TEST(TransferField, CanBeCancelledInEitherPart) {
    const auto mesh = sphere(5, 3);
    for (const double until : {0.0, 0.7}) {
        double last = 0;
        const auto field =
            compute_transfer_field(mesh, plain, 1, {.directions = 64}, [&](double fraction) {
                last = fraction;
                return fraction <= until;
            });
        ASSERT_FALSE(field);
        EXPECT_EQ(field.error(), "cancelled");
        EXPECT_GT(last, until);
        EXPECT_LT(last, 1);
    }
}

TEST(TransferField, ProgressGrowsToOne) {
    double last = 0;
    const auto field =
        compute_transfer_field(sphere(5, 3), plain, 1, {.directions = 64}, [&](double fraction) {
            EXPECT_GE(fraction, last);
            last = fraction;
            return true;
        });
    ASSERT_TRUE(field);
    EXPECT_NEAR(last, 1, 1e-12);
}

TEST(TransferField, RefusesWhatCannotBeComputed) {
    const auto few = compute_transfer_field(sphere(5, 1), plain, 1, {.directions = 30});
    ASSERT_FALSE(few);
    EXPECT_EQ(few.error(), "30 directions cannot carry 25 coefficients, expected 50 or more");
    const auto clear = compute_transfer_field(sphere(5, 1), {{1, 1, 1}, {0, 0, 0}, 1}, 1, {});
    ASSERT_FALSE(clear);
    EXPECT_EQ(clear.error(),
              "the medium scatters in no channel, expected a sigma_s' above 0 in one of them");
    const auto nothing = compute_transfer_field(Mesh{}, plain, 1, {});
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error(), "the mesh has no triangle with area, expected a surface");
}

// Snow: sigma_tr = 0, the kernel falls like 1/r^3 and everything stays finite.
TEST(TransferField, WithoutAbsorptionItIsFinite) {
    const Medium snow{{0, 0, 0}, {2, 2, 2}, 1.3};
    const auto field = field_of(sphere(5, 3), snow, {.directions = 128});
    for (const float t : field.transfer)
        ASSERT_LE(std::abs(t), 1) << "a NaN fails, too";
}

// Fewer bands alone are fitted by least squares to the same thousand samples.  On the sphere's
// zonal transfer the bands above them alias by the error of Fibonacci's rule for products of bands,
// which is below 1e-3.
TEST(TransferField, HasFewerBandsInItsFirstCoefficients) {
    const auto mesh = renderer::geometry::torus(1, 0.4, 24, 12);
    const auto six = field_of(mesh, plain, {.mode = Mode::ShadowedDiffuse, .bands = 6});
    for (const int bands : {1, 3, 6}) {
        const auto first = first_bands(six, bands);
        const auto alone = field_of(mesh, plain, {.mode = Mode::ShadowedDiffuse, .bands = bands});
        ASSERT_EQ(first.transfer.size(), alone.transfer.size());
        EXPECT_EQ(first.bands, bands);
        double difference = 0, squares = 0;
        for (std::size_t i = 0; i < alone.transfer.size(); ++i) {
            const double t = static_cast<double>(alone.transfer[i]);
            difference += std::pow(static_cast<double>(first.transfer[i]) - t, 2);
            squares += t * t;
        }
        EXPECT_LE(std::sqrt(difference / squares), bands == 6 ? 0.0 : 1e-3) << bands;
    }
}

} // namespace
