#include "renderer/geometry/bodies.h"
#include "renderer/harmonics/basis.h"
#include "renderer/smoothing/cotangent_laplacian.h"
#include "renderer/smoothing/surface_smoother.h"
#include "tests/renderer/geometry/assembly.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

using namespace renderer;
using smoothing::SurfaceSmoother;

std::vector<double> smoothed(const geometry::Mesh& mesh,
                             double t,
                             const std::vector<double>& values,
                             std::size_t columns = 1) {
    auto smooth = SurfaceSmoother(mesh).smooth(t, values, columns);
    EXPECT_TRUE(smooth) << smooth.error();
    return smooth.value_or(std::vector<double>());
}

double area_weighted_mean(const geometry::Mesh& mesh, const std::vector<double>& values) {
    const auto areas = smoothing::cotangent_laplacian(mesh).areas;
    double sum = 0, area = 0;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        sum += areas[i] * values[i];
        area += areas[i];
    }
    return sum / area;
}

/// A rough function of position: nothing that any Laplacian leaves alone.
std::vector<double> rough_values(const geometry::Mesh& mesh) {
    std::vector<double> values;
    for (const auto& p : mesh.positions)
        values.push_back(std::sin(17 * p.x) * std::cos(29 * p.y) + std::sin(41 * p.z + p.x));
    return values;
}

/// Long needles and caps: a torus whose cells are 60 times as long as they are wide, sheared.
geometry::Mesh obtuse_torus() {
    auto torus = geometry::torus(1, 0.4, 6, 240);
    for (auto& p : torus.positions)
        p.z += 0.5 * p.x;
    return torus;
}

TEST(SurfaceSmoother, LeavesConstantsAlone) {
    for (const auto& mesh : {geometry::sphere(1, 4), geometry::shell(1, 0.5, 3), obtuse_torus()})
        for (const double t : {0.01, 1.0, 100.0})
            for (const double value :
                 smoothed(mesh, t, std::vector<double>(mesh.positions.size(), 0.7)))
                ASSERT_NEAR(value, 0.7, 1e-10) << t;
}

TEST(SurfaceSmoother, GivesBackItsValuesBitForBitAtNoTime) {
    const auto mesh = geometry::sphere(1, 3);
    const auto values = rough_values(mesh);
    EXPECT_EQ(smoothed(mesh, 0, values), values);
}

TEST(SurfaceSmoother, KeepsTheAreaWeightedMean) {
    for (const auto& mesh : {geometry::torus(1, 0.3, 40, 20), obtuse_torus()}) {
        const auto values = rough_values(mesh);
        for (const double t : {0.001, 0.1, 10.0})
            EXPECT_NEAR(area_weighted_mean(mesh, smoothed(mesh, t, values)),
                        area_weighted_mean(mesh, values), 1e-12)
                << t;
    }
}

// x = mean + O(1/(1 + t lambda_1)), lambda_1 = 2 on the unit sphere and |values| <= 2.
TEST(SurfaceSmoother, GoesFlatAfterALongTime) {
    const auto mesh = geometry::sphere(1, 4);
    const auto values = rough_values(mesh);
    const double mean = area_weighted_mean(mesh, values);
    for (const double value : smoothed(mesh, 1e6, values))
        ASSERT_NEAR(value, mean, 2 / 2e6);
}

/// Relative error, area-weighted rms, of smoothing the harmonics of degree l on an icosphere.
double harmonic_error(int l, double t, int subdivisions) {
    constexpr double R = 2;
    const auto mesh = geometry::sphere(R, subdivisions);
    const auto areas = smoothing::cotangent_laplacian(mesh).areas;
    std::vector<double> values, y(static_cast<std::size_t>((l + 1) * (l + 1)));
    for (const auto& p : mesh.positions) {
        harmonics::evaluate(l + 1, glm::normalize(p), y);
        values.insert(values.end(), y.begin() + harmonics::flat_index(l, -l), y.end());
    }
    const auto columns = static_cast<std::size_t>(2 * l + 1);
    const auto smooth = smoothed(mesh, t, values, columns);
    const double eigenvalue = 1 / (1 + t * l * (l + 1) / (R * R));
    double error = 0, norm = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        error += areas[i / columns] * std::pow(smooth[i] - eigenvalue * values[i], 2);
        norm += areas[i / columns] * std::pow(eigenvalue * values[i], 2);
    }
    return std::sqrt(error / norm);
}

// Spherical harmonics are eigenfunctions of the sphere's Laplacian, -l(l+1)/R^2, so that one
// implicit step scales degree l by 1/(1 + t l(l+1)/R^2); l = 1 is the normal.  What is left is the
// icosphere's error: it quarters when edges halve, and is 0.006 % (l = 1), 0.06 % (l = 2) and 0.2 %
// (l = 3) at 2562 vertices for t = 0.1 R^2.
TEST(SurfaceSmoother, ScalesHarmonicsOfASphereByTheirEigenvalues) {
    constexpr double t = 0.4; // 0.1 R^2
    for (const int l : {1, 2, 3}) {
        const double coarse = harmonic_error(l, t, 3), fine = harmonic_error(l, t, 4),
                     finest = harmonic_error(l, t, 5);
        EXPECT_GE(coarse / fine, 3.8) << l; // second order: 4
        EXPECT_GE(fine / finest, 3.8) << l;
        EXPECT_LE(fine, (std::array{0.0, 7e-5, 6e-4, 2.1e-3}[static_cast<std::size_t>(l)])) << l;
    }
}

TEST(SurfaceSmoother, KnowsNoUnitOfLength) {
    const auto mesh = geometry::torus(1, 0.3, 20, 12);
    const auto values = rough_values(mesh);
    const auto expected = smoothed(mesh, 0.05, values);
    for (const double scale : {1e-6, 1e6}) {
        auto scaled = mesh;
        for (auto& p : scaled.positions)
            p *= scale;
        const auto smooth = smoothed(scaled, 0.05 * scale * scale, values);
        for (std::size_t i = 0; i < values.size(); ++i)
            ASSERT_NEAR(smooth[i], expected[i], 1e-12) << scale;
    }
}

// No negative weight is left, so the inverse has no negative entry (M + tL is an M-matrix), and
// nothing overshoots, however obtuse the triangles are.
TEST(SurfaceSmoother, StaysWithinTheRangeOfItsValuesOnObtuseTriangles) {
    const auto mesh = obtuse_torus();
    ASSERT_GT(smoothing::cotangent_laplacian(mesh).clamped, mesh.positions.size() / 10);
    std::vector<double> spike(mesh.positions.size(), 0.0);
    spike[mesh.positions.size() / 2] = 1;
    for (const double t : {1e-4, 0.01, 1.0, 100.0})
        for (const double value : smoothed(mesh, t, spike)) {
            ASSERT_GE(value, -1e-15) << t;
            ASSERT_LE(value, 1) << t;
        }
}

TEST(SurfaceSmoother, PassesNothingBetweenComponents) {
    const auto sphere = geometry::sphere(1, 2);
    const auto first = sphere.positions.size();
    const auto mesh = geometry::together(sphere, sphere); // in the very same place
    std::vector<double> values(mesh.positions.size(), 1.0);
    std::fill(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first), 0.0);
    const auto smooth = smoothed(mesh, 10, values);
    for (std::size_t i = 0; i < smooth.size(); ++i)
        ASSERT_NEAR(smooth[i], i < first ? 0 : 1, 1e-12);
}

TEST(SurfaceSmoother, LeavesAnIsolatedVertexItsValue) {
    auto mesh = geometry::sphere(1, 2);
    mesh.positions.emplace_back(5, 5, 5);
    std::vector<double> values(mesh.positions.size(), 1.0);
    values.back() = -3;
    const auto smooth = smoothed(mesh, 1, values);
    EXPECT_EQ(smooth.back(), -3);
    EXPECT_NEAR(smooth.front(), 1, 1e-12);
}

TEST(SurfaceSmootherDeathTest, WantsValuesForEveryVertexAndATimeNotBeforeTheStart) {
    SurfaceSmoother smoother(geometry::sphere(1, 0));
    const std::vector<double> values(11);
    EXPECT_DEATH((void)smoother.smooth(1, values, 1), "columns");
    EXPECT_DEATH((void)smoother.smooth(NAN, values, 1), "t >= 0");
}

} // namespace
