#include "renderer/diffusion/point_tree.h"
#include "renderer/diffusion/surface_samples.h"
#include "renderer/geometry/bodies.h"
#include "renderer/materials.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace {

using namespace renderer::diffusion;
using renderer::Medium;
using renderer::geometry::sphere;
using std::numbers::pi;

double total(const std::vector<double>& areas) {
    return std::accumulate(areas.begin(), areas.end(), 0.0);
}

std::vector<double> nearest_neighbours(const SurfaceSamples& samples) {
    std::vector<double> nearest;
    for (const auto& p : samples.positions) {
        double best = std::numeric_limits<double>::infinity();
        for (const auto& q : samples.positions)
            if (&p != &q)
                best = std::min(best, glm::distance(p, q));
        nearest.push_back(best);
    }
    return nearest;
}

TEST(SurfaceSamples, WantTheDensestChannelsTransportMeanFreePath) {
    // marble's blue: sigma_t' = 3.00 + 0.0071
    EXPECT_NEAR(wanted_spacing(renderer::measured_medium("marble").value()), 1 / 3.0071, 1e-12);
    const auto in_metres = in_model_units(renderer::measured_medium("marble").value(), 1000);
    EXPECT_NEAR(wanted_spacing(in_metres), 1 / 3007.1, 1e-12);
}

TEST(SurfaceSamples, AreVerticesWhereTheseAreDenseEnough) {
    const auto mesh = sphere(5, 3);
    const auto samples = sample_surface(mesh, {.spacing = 1});
    EXPECT_EQ(samples.positions, mesh.positions);
    EXPECT_FALSE(samples.undersampled);
    // the inscribed polyhedron lacks about edge^2 / (8 R^2) of the sphere
    EXPECT_NEAR(total(samples.areas) / (4 * pi * 25), 1, 0.01);
}

TEST(SurfaceSamples, FillWhatVerticesLeaveOpen) {
    const auto mesh = renderer::geometry::slab(20, 10, 4, 1); // corners only
    const double area = 2 * (20 * 10 + 20 * 4 + 10 * 4);
    const auto samples = sample_surface(mesh, {.spacing = 1});
    EXPECT_FALSE(samples.undersampled);
    EXPECT_NEAR(total(samples.areas), area, 1e-4); // cells are kept in float
    const auto nearest = nearest_neighbours(samples);
    EXPECT_LE(total(nearest) / static_cast<double>(nearest.size()), 1);
    // packed as disks are: 1.44 of the squared radius for each
    EXPECT_NEAR(area / static_cast<double>(samples.positions.size()), 1.44 * 0.65 * 0.65, 0.1);
}

TEST(SurfaceSamples, KeepTheirDistanceOnASmoothBody) {
    const auto samples = poisson_samples(sphere(5, 4), {.spacing = 1});
    for (const double distance : nearest_neighbours(samples))
        EXPECT_GT(distance, 0.65);
    for (const auto& n : samples.normals)
        EXPECT_NEAR(glm::length(n), 1, 1e-6);
    for (std::size_t q = 0; q < samples.positions.size(); ++q)
        EXPECT_GE(glm::dot(samples.normals[q], glm::normalize(samples.positions[q])), 0.999);
}

// Each side of a sheet thinner than the spacing has its own samples and its own area.
TEST(SurfaceSamples, TellTheSidesOfASheetApart) {
    const auto samples = sample_surface(renderer::geometry::slab(20, 20, 0.1, 1), {.spacing = 1});
    double front = 0, back = 0;
    for (std::size_t q = 0; q < samples.positions.size(); ++q) {
        if (samples.positions[q].z > 0.05 - 1e-9)
            front += samples.areas[q];
        if (samples.positions[q].z < -0.05 + 1e-9)
            back += samples.areas[q];
    }
    EXPECT_NEAR(front, 400, 1e-2);
    EXPECT_NEAR(back, 400, 1e-2);
}

TEST(SurfaceSamples, SayWhenTheyAreTooFew) {
    const auto mesh = renderer::geometry::slab(20, 10, 4, 1);
    const auto samples = sample_surface(mesh, {.spacing = 0.1, .most_samples = 1000});
    EXPECT_TRUE(samples.undersampled);
    EXPECT_LE(samples.positions.size(), 1100u);
    EXPECT_GE(samples.positions.size(), 700u); // but as many as were allowed, about
    EXPECT_GT(samples.spacing, 0.1);
    EXPECT_NEAR(total(samples.areas), 640, 1e-3);
}

TEST(SurfaceSamples, AreTheSameForTheSameSeed) {
    const auto mesh = renderer::geometry::slab(20, 10, 4, 1);
    const auto a = poisson_samples(mesh, {.spacing = 1, .seed = 3});
    const auto b = poisson_samples(mesh, {.spacing = 1, .seed = 3});
    const auto c = poisson_samples(mesh, {.spacing = 1, .seed = 4});
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.areas, b.areas);
    EXPECT_NE(a.positions, c.positions);
}

// The samples serve the kernel: the densest channel's row sums at the vertices of a body too coarse
// for it.  The polyhedron itself lacks 0.2 %.
TEST(SurfaceSamples, CarryTheKernelAtTheWantedSpacing) {
    const auto mesh = sphere(5, 4);
    const Medium dense{{0.1, 0.1, 0.1}, {4, 4, 4}, 1};
    const auto samples = poisson_samples(mesh, {.spacing = wanted_spacing(dense)});
    const std::vector<float> ones(samples.positions.size(), 1);
    const auto kernel = dipoles(dense);
    const auto sums = spread(PointTree(samples, ones, 1), kernel, mesh.positions, 0.05);
    double mean = 0, squares = 0, worst = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const double off = static_cast<double>(sums[3 * v]) / sphere_total(kernel[0], 5) - 1;
        mean += off / static_cast<double>(mesh.positions.size());
        squares += off * off / static_cast<double>(mesh.positions.size());
        worst = std::max(worst, std::abs(off));
    }
    EXPECT_LE(std::abs(mean), 0.003);
    EXPECT_LE(std::sqrt(squares), 0.005);
    EXPECT_LE(worst, 0.015);
}

} // namespace
