#include "renderer/diffusion/dipole.h"
#include "renderer/geometry/bodies.h"
#include "renderer/harmonics/basis.h"
#include "renderer/materials.h"
#include "renderer/smoothing/shading_fields.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace renderer;
using namespace renderer::smoothing;
using std::numbers::pi;

/// Two sheets back to back, facing away from each other: a fold whose normals cancel.
geometry::Mesh fold() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
}

TEST(DiffusionTime, IsAQuarterOfTheMeanSquareRadius) {
    EXPECT_EQ(diffusion_time(24, Millimetres{100}), 6);
    EXPECT_EQ(diffusion_time(0, Millimetres{100}), 0);
}

TEST(DiffusionTime, IsCappedAtAnEighthOfTheDiameterSquared) {
    EXPECT_EQ(diffusion_time(1e4, Millimetres{80}), 100);
    EXPECT_EQ(diffusion_time(std::numeric_limits<double>::infinity(), Millimetres{80}), 100);
}

/// int_0^inf r^power R_d(r) dr by the double-exponential rule r = exp(pi/2 sinh u).
double moment(const diffusion::Dipole& dipole, int power) {
    double sum = 0;
    constexpr double step = 1.0 / 64;
    for (double u = -4; u <= 4; u += step) {
        const double r = std::exp(pi / 2 * std::sinh(u));
        sum += step * pi / 2 * std::cosh(u) * std::pow(r, power + 1) *
               diffusion::diffuse_reflectance(dipole, r);
    }
    return sum;
}

// The closed form of <r^2> against quadrature of the kernel, for every channel that absorbs.
TEST(DiffusionTime, OfTheMeasuredMaterialsIsThatOfTheirKernels) {
    int checked = 0;
    for (const auto& name : measured_names())
        for (const auto& dipole : diffusion::dipoles(measured_medium(name).value())) {
            if (dipole.sigma_tr == 0)
                continue;
            const double r2 = moment(dipole, 3) / moment(dipole, 1);
            const double t =
                diffusion_time(diffusion::mean_square_radius(dipole), Millimetres{1e6});
            EXPECT_NEAR(4 * t / r2, 1, 1e-13) << name;
            ++checked;
        }
    EXPECT_EQ(checked, 33);
}

// On a sphere the normal is an eigenvector: only its length changes, and that is made 1 again.
// What is left is the icosphere's unevenness, second order in its edges.
TEST(SmoothedNormals, OfASphereStay) {
    const auto worst = [](int subdivisions) {
        const auto mesh = geometry::sphere(50, subdivisions);
        std::vector<glm::dvec3> normals;
        for (const auto& p : mesh.positions)
            normals.push_back(glm::normalize(p));
        SurfaceSmoother smoother(mesh);
        const auto smooth = smoothed_normals(smoother, 100, normals).value();
        double sum = 0;
        for (std::size_t i = 0; i < smooth.size(); ++i) {
            EXPECT_NEAR(glm::length(smooth[i]), 1, 1e-14);
            sum += glm::dot(smooth[i] - normals[i], smooth[i] - normals[i]);
        }
        return std::sqrt(sum / static_cast<double>(smooth.size()));
    };
    const double coarse = worst(3), fine = worst(4);
    EXPECT_LE(fine, 1e-4); // rms, radians
    EXPECT_GE(coarse / fine, 3.5);
}

TEST(SmoothedNormals, AtNoTimeAreTheNormalsBitForBit) {
    const auto mesh = geometry::torus(1, 0.4, 12, 8);
    const auto normals = geometry::vertex_normals(mesh);
    SurfaceSmoother smoother(mesh);
    EXPECT_EQ(smoothed_normals(smoother, 0, normals).value(), normals);
}

TEST(SmoothedNormals, RoundOffAnEdge) {
    const auto mesh = geometry::slab(10, 10, 2, 20);
    const auto normals = geometry::vertex_normals(mesh);
    SurfaceSmoother smoother(mesh);
    const auto smooth = smoothed_normals(smoother, 1, normals).value();
    for (std::size_t i = 0; i < smooth.size(); ++i) {
        const auto& p = mesh.positions[i];
        // One millimetre inside the edge of the upper face, midway along it.
        if (p.z > 0.9 && std::abs(p.x - 4) < 1e-9 && std::abs(p.y) < 1e-9) {
            EXPECT_NEAR(normals[i].z, 1, 1e-12);
            EXPECT_GE(smooth[i].x, 0.1); // leans outward
            EXPECT_GE(smooth[i].z, 0.5);
            return;
        }
    }
    FAIL() << "no such vertex";
}

TEST(SmoothedNormals, ThatCancelStayAsTheyWere) {
    const auto mesh = fold();
    SurfaceSmoother smoother(mesh);
    const std::vector<glm::dvec3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}};
    // After a long time all have the mean (1/3, 0, 0); with the third against the first they
    // cancel.
    const std::vector<glm::dvec3> cancelling{{0, 0, 1}, {0.6, 0, -0.8}, {-0.6, 0, -0.2}};
    EXPECT_NEAR(smoothed_normals(smoother, 1e9, normals).value()[0].x, 1, 1e-6);
    const auto smooth = smoothed_normals(smoother, 1e9, cancelling).value();
    EXPECT_EQ(smooth, cancelling);
}

TEST(SmoothedNormals, OfAnIsolatedVertexStay) {
    auto mesh = geometry::sphere(1, 2);
    mesh.positions.emplace_back(5, 5, 5);
    auto normals = geometry::vertex_normals(mesh);
    EXPECT_EQ(normals.back(), glm::dvec3(0)); // it has none
    SurfaceSmoother smoother(mesh);
    EXPECT_EQ(smoothed_normals(smoother, 1, normals).value().back(), glm::dvec3(0));
    normals.back() = {0, 1, 0};
    EXPECT_EQ(smoothed_normals(smoother, 1, normals).value().back(), glm::dvec3(0, 1, 0));
}

/// sum e_lm y_lm(L) of one vertex.
double irradiance_from(const std::vector<double>& e, std::size_t vertex, glm::dvec3 to_light) {
    std::vector<double> y(9);
    harmonics::evaluate(3, to_light, y);
    double sum = 0;
    for (std::size_t i = 0; i < 9; ++i)
        sum += e[9 * vertex + i] * y[i];
    return sum;
}

// Three bands of the clamped cosine: 1/4 + cos/2 + (5/32)(3 cos^2 - 1), so 17/16 facing the light,
// 3/32 at the terminator (true: 0), 1/16 on the far side (true: 0).
TEST(SmoothedIrradiance, AtNoTimeIsTheClampedCosineInThreeBands) {
    const auto mesh = geometry::sphere(1, 0);
    SurfaceSmoother smoother(mesh);
    const std::vector<glm::dvec3> normals(mesh.positions.size(), glm::dvec3(0, 0, 1));
    const auto e = smoothed_irradiance(smoother, 0, normals).value();
    EXPECT_NEAR(irradiance_from(e, 0, {0, 0, 1}), 17.0 / 16, 1e-14);
    EXPECT_NEAR(irradiance_from(e, 0, {1, 0, 0}), 3.0 / 32, 1e-14);
    EXPECT_NEAR(irradiance_from(e, 0, {0, 0, -1}), 1.0 / 16, 1e-14);
}

// Band l of a sphere of radius R is scaled by 1/(1 + t l(l+1)/R^2).
TEST(SmoothedIrradiance, OfASphereHasItsBandsScaledByTheirEigenvalues) {
    constexpr double R = 50, t = 250;
    const auto mesh = geometry::sphere(R, 5);
    std::vector<glm::dvec3> normals;
    for (const auto& p : mesh.positions)
        normals.push_back(glm::normalize(p));
    SurfaceSmoother smoother(mesh);
    const auto e = smoothed_irradiance(smoother, t, normals).value();
    const glm::dvec3 L = glm::normalize(glm::dvec3(1, 2, 3));
    double squares = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double mu = glm::dot(normals[i], L);
        const double expected = 0.25 + mu / 2 / (1 + 2 * t / (R * R)) +
                                5.0 / 32 * (3 * mu * mu - 1) / (1 + 6 * t / (R * R));
        squares += std::pow(irradiance_from(e, i, L) - expected, 2);
    }
    // 10242 vertices: the second-order error of band 2 is 1.5e-4 of its 0.14 rms.
    EXPECT_LE(std::sqrt(squares / static_cast<double>(normals.size())), 3e-5);
}

TEST(SmoothedIrradiance, AfterALongTimeIsTheSameEverywhere) {
    const auto mesh = geometry::torus(1, 0.4, 24, 16);
    SurfaceSmoother smoother(mesh);
    const auto e = smoothed_irradiance(smoother, 1e6, geometry::vertex_normals(mesh)).value();
    const double anywhere = irradiance_from(e, 0, {0, 0, 1});
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        ASSERT_NEAR(irradiance_from(e, i, {0, 0, 1}), anywhere, 1e-5);
    EXPECT_GT(anywhere, 0);
}

TEST(SmoothedIrradiance, OfAVertexWithoutANormalIsNone) {
    auto mesh = geometry::sphere(1, 1);
    mesh.positions.emplace_back(5, 5, 5);
    SurfaceSmoother smoother(mesh);
    const auto e = smoothed_irradiance(smoother, 1, geometry::vertex_normals(mesh)).value();
    EXPECT_EQ(irradiance_from(e, mesh.positions.size() - 1, {0, 0, 1}), 0);
}

} // namespace
