#include "renderer/diffusion/jensen.h"
#include "renderer/geometry/bodies.h"
#include "renderer/harmonics/gauss_legendre.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace {

using namespace renderer::diffusion;
using renderer::Medium;
using renderer::geometry::sphere;
using renderer::harmonics::legendre_polynomial;
using std::numbers::pi;

const Medium plain{{0.1, 0.1, 0.1}, {1, 1, 1}, 1};

/// Degree l of the clamped cosine's zonal expansion: pi, 2 pi/3, pi/4, 0, -pi/24, 0, pi/64, ...
double clamped_cosine(int l) {
    if (l == 1)
        return 2 * pi / 3;
    if (l % 2 == 1)
        return 0;
    double binomial = 1; // l! / (2^l (l/2)!^2)
    for (int k = 1; k <= l / 2; ++k)
        binomial *= (2.0 * k - 1) / (2.0 * k);
    const double sign = l / 2 % 2 == 1 ? 1 : -1;
    return sign * 2 * pi / ((l + 2) * (l - 1)) * binomial;
}

// A sphere under one light, exactly: every degree of the clamped cosine scaled by its eigenvalue.
class LitSphere {
  public:
    LitSphere(const Dipole& kernel, double radius) {
        for (int l = 0; l <= 40; ++l)
            degrees_.push_back(sphere_eigenvalue(kernel, radius, l) * clamped_cosine(l) *
                               (2 * l + 1) / (4 * pi) / pi);
    }

    double radiance(double cosine) const {
        double sum = 0;
        for (std::size_t l = 0; l < degrees_.size(); ++l)
            sum += degrees_[l] * legendre_polynomial(static_cast<int>(l), cosine);
        return sum;
    }

  private:
    std::vector<double> degrees_;
};

TEST(JensenDipole, SphereUnderOneLightIsItsExpansion) {
    const auto mesh = sphere(5, 4);
    const DipoleBody body(mesh, plain, 1);
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(1, 2, -3));
    const auto radiance = body.exit_radiance(to_light);
    const LitSphere truth(dipoles(plain)[0], 5);
    const double brightest = truth.radiance(1);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const double cosine = glm::dot(glm::normalize(mesh.positions[v]), to_light);
        // flat facets, samples and tree together: 1 % of the brightest
        ASSERT_NEAR(static_cast<double>(radiance[v].x), truth.radiance(cosine), 0.01 * brightest)
            << "vertex " << v << " at cosine " << cosine;
    }
}

std::size_t middle_of_front(const renderer::geometry::Mesh& mesh) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (glm::distance(mesh.positions[v], glm::dvec3(0, 0, 5)) < 1e-9)
            return v;
    ADD_FAILURE() << "no vertex in the middle";
    return 0;
}

// The middle of a wide slab's lit face is a half-space: what lies beyond 20 mm of it is e^-11.
TEST(JensenDipole, WideSlabUnderNormalLightIsThePlaneTotal) {
    const auto mesh = renderer::geometry::slab(40, 40, 10, 2);
    const DipoleBody body(mesh, plain, 1);
    ASSERT_GT(body.samples().positions.size(), mesh.positions.size()); // points were added
    const auto radiance = body.exit_radiance({0, 0, 1});
    const double middle = static_cast<double>(radiance[middle_of_front(mesh)].x);
    EXPECT_NEAR(middle * pi / 0.4040250, 1, 0.02);
}

// Light that meets the boundary head-on loses F0 = 0.04.
TEST(JensenDipole, TheBoundaryTakesItsShare) {
    const auto mesh = renderer::geometry::slab(40, 40, 10, 2);
    Medium glazed = plain;
    glazed.index = 1.5;
    const auto kernels = dipoles(glazed);
    const auto radiance = DipoleBody(mesh, glazed, 1).exit_radiance({0, 0, 1});
    const double middle = static_cast<double>(radiance[middle_of_front(mesh)].x);
    EXPECT_NEAR(middle * pi / (0.96 * plane_total(kernels[0])), 1, 0.02);
}

// A body of another unit of length is the same body.
TEST(JensenDipole, OnlyMillimetresCount) {
    const glm::dvec3 to_light(0, 0, 1);
    // a power of two: nothing is rounded differently, and the same samples are drawn
    const auto in_mm = DipoleBody(sphere(5, 3), plain, 1).exit_radiance(to_light);
    const auto in_large = DipoleBody(sphere(5.0 / 1024, 3), plain, 1024).exit_radiance(to_light);
    for (std::size_t v = 0; v < in_mm.size(); ++v)
        ASSERT_NEAR(in_mm[v].y, in_large[v].y, 1e-5F * in_mm[v].y);
}

TEST(JensenDipole, ABodyShadowsItself) {
    const auto mesh = renderer::geometry::torus(20, 4, 120, 24);
    const auto samples = vertex_samples(mesh);
    const Exposure exposure(mesh, samples, 1);
    for (std::size_t q = 0; q < samples.positions.size(); ++q) {
        const auto& p = samples.positions[q];
        const auto& n = samples.normals[q];
        // The inner wall on the far side faces the light along +x; the ring's near side stands
        // between.
        if (p.x < -15.9 && p.x > -16.5 && n.x > 0.99 && std::abs(p.z) < 0.5) {
            EXPECT_EQ(exposure(q, {1, 0, 0}), 0) << q;
        }
        if (p.x > 23.9) {
            EXPECT_NEAR(exposure(q, {1, 0, 0}), n.x, 1e-12) << q;
        }
    }
}

} // namespace
