#include "renderer/diffusion/dipole.h"
#include "renderer/harmonics/gauss_legendre.h"
#include "renderer/materials.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace {

using namespace renderer::diffusion;
using renderer::Medium;
using renderer::harmonics::gauss_legendre;
using std::numbers::pi;

Medium grey(double sigma_a, double sigma_s_reduced, double eta) {
    return {{sigma_a, sigma_a, sigma_a}, {sigma_s_reduced, sigma_s_reduced, sigma_s_reduced}, eta};
}

Dipole plain() {
    return dipoles(grey(0.1, 1, 1))[0];
}

Dipole skin1_red() {
    return dipoles(renderer::measured_medium("skin1").value())[0];
}

/// Integral of f(r) 2 pi r dr over 0..far, by octaves of r: nothing shared with the tested code but
/// the nodes.
double over_plane(const std::function<double(double)>& f, double far) {
    static const auto nodes = gauss_legendre(40);
    double sum = 0;
    for (double end = far; end > 1e-6; end /= 2)
        for (const auto& [x, weight] : nodes) {
            const double r = 0.5 * end + 0.25 * end * (1 + x);
            sum += 0.25 * end * weight * f(r) * 2 * pi * r;
        }
    return sum;
}

// Five decimals are printed.
TEST(Dipole, BoundaryMismatchIsTheTabulatedOne) {
    EXPECT_NEAR(boundary_mismatch(1.30), 2.60008, 0.5e-5);
    EXPECT_NEAR(boundary_mismatch(1.33), 2.78751, 0.5e-5);
    EXPECT_NEAR(boundary_mismatch(1.40), 3.24615, 0.5e-5);
    EXPECT_NEAR(boundary_mismatch(1.50), 3.95474, 0.5e-5);
}

TEST(Dipole, WithoutABoundaryTheMismatchIsExactlyOne) {
    EXPECT_EQ(boundary_mismatch(1), 1);
    EXPECT_EQ(plain().z_virtual, (1 + 4.0 / 3) / 1.1);
}

// A gas bubble's wall lets diffuse light out of the thinner side more easily than into it.
TEST(Dipole, AnIndexBelowOneHoldsLittleBack) {
    const double mismatch = boundary_mismatch(1 / 1.5);
    EXPECT_NEAR(mismatch, (1 + 0.0917780) / (1 - 0.0917780), 1e-6); // F_dr of 1/1.5 is F_ext of 1.5
}

TEST(Dipole, PlaneTotalIsTheTabulatedOneAndTheIntegralOfTheKernel) {
    EXPECT_NEAR(plane_total(plain()), 0.4040250, 0.5e-7);
    EXPECT_NEAR(plane_total(skin1_red()), 0.4360489, 0.5e-7);
    for (const auto& dipole : {plain(), skin1_red()}) {
        const auto kernel = [&](double r) { return diffuse_reflectance(dipole, r); };
        // what lies beyond 60 diffusion lengths is e^-60
        EXPECT_NEAR(over_plane(kernel, 60 / dipole.sigma_tr), plane_total(dipole), 1e-9);
    }
}

TEST(Dipole, PlaneTotalHasThePapersClosedForm) {
    for (const double eta : {1.0, 1.3, 1.5})
        for (const double sigma_a : {0.0, 0.01, 1.0}) {
            const auto dipole = dipoles(grey(sigma_a, 1, eta))[0];
            const double alpha = 1 / (1 + sigma_a), root = std::sqrt(3 * (1 - alpha));
            EXPECT_NEAR(plane_total(dipole),
                        alpha / 2 * (1 + std::exp(-4.0 / 3 * boundary_mismatch(eta) * root)) *
                            std::exp(-root),
                        1e-14);
        }
}

// Seven decimals are printed.  The second row was computed with A rounded to 2.60008, which moves
// its first value by 3e-8.
TEST(Dipole, SphereEigenvaluesAreTheTabulatedOnes) {
    const double first[] = {0.4036307, 0.3677802, 0.3168077, 0.2649049, 0.2184155};
    const double second[] = {0.4217585, 0.3252988, 0.2449735, 0.1864068, 0.1432735};
    for (int l = 0; l < 5; ++l) {
        EXPECT_NEAR(sphere_eigenvalue(plain(), 5, l), first[l], 0.5e-7) << l;
        EXPECT_NEAR(sphere_eigenvalue(skin1_red(), 5, l), second[l], 0.8e-7) << l;
    }
}

TEST(Dipole, SphereTotalIsTheEigenvalueOfDegreeZero) {
    for (const double radius : {0.01, 1.0, 5.0, 1000.0})
        for (const auto& dipole : {plain(), skin1_red(), dipoles(grey(0, 1, 1.3))[0]})
            EXPECT_NEAR(sphere_eigenvalue(dipole, radius, 0), sphere_total(dipole, radius), 1e-13);
}

TEST(Dipole, MeanSquareRadiusIsTheKernelsSecondMoment) {
    for (const auto& dipole : {plain(), skin1_red()}) {
        const auto moment = [&](double r) { return r * r * diffuse_reflectance(dipole, r); };
        const double truth = over_plane(moment, 80 / dipole.sigma_tr) / plane_total(dipole);
        EXPECT_NEAR(mean_square_radius(dipole) / truth, 1, 1e-9);
    }
}

// ---- hard cases

TEST(Dipole, KernelAtDistanceZeroIsFinite) {
    for (const auto& dipole : {plain(), skin1_red()}) {
        double sum = 0;
        for (const double z : {dipole.z_real, dipole.z_virtual})
            sum += (dipole.sigma_tr + 1 / z) * std::exp(-dipole.sigma_tr * z) / z;
        EXPECT_NEAR(diffuse_reflectance(dipole, 0) / (dipole.alpha / (4 * pi) * sum), 1, 1e-14);
    }
}

TEST(Dipole, WithoutAbsorptionEverythingComesBackAtLast) {
    const auto dipole = dipoles(grey(0, 2, 1.3))[0];
    EXPECT_EQ(dipole.sigma_tr, 0);
    EXPECT_EQ(plane_total(dipole), 1);
    for (const double r : {0.0, 0.3, 10.0}) {
        double sum = 0;
        for (const double z : {dipole.z_real, dipole.z_virtual})
            sum += z / std::pow(r * r + z * z, 1.5);
        EXPECT_NEAR(diffuse_reflectance(dipole, r) / (sum / (4 * pi)), 1, 1e-14);
    }
    EXPECT_EQ(mean_square_radius(dipole), std::numeric_limits<double>::infinity());
}

TEST(Dipole, AChannelThatDoesNotScatterReflectsNothing) {
    for (const double sigma_a : {0.0, 1.0}) {
        const auto dipole = dipoles(grey(sigma_a, 0, 1.3))[0];
        EXPECT_EQ(diffuse_reflectance(dipole, 0), 0);
        EXPECT_EQ(plane_total(dipole), 0);
        EXPECT_EQ(sphere_total(dipole, 1), 0);
        EXPECT_EQ(mean_square_radius(dipole), 0);
    }
}

TEST(Dipole, ChannelsAreRedGreenAndBlue) {
    const auto marble = dipoles({{0.0021, 0.0041, 0.0071}, {2.19, 2.62, 3.00}, 1.5});
    const double sigma_t[] = {2.1921, 2.6241, 3.0071};
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(marble[c].z_real, 1 / sigma_t[c], 1e-15) << c;
}

// ---- the model against transport theory

// The exact reflectance of a half-space at normal incidence (smooth boundary, isotropic phase
// function) against Ft(0) times the dipole's: what remains is the model's error, not the code's.
// The bands are what the literature and our own transport computation say of the dipole: 1 % for
// apple's red, 3 % for marble's, 13 % for ketchup's, 8-15 % for skin's green and blue, always high.
TEST(Dipole, IsAsFarFromTransportTheoryAsIsKnownOfIt) {
    struct Case {
        const char* material;
        std::size_t channel;
        double exact, low, high;
    };

    const Case cases[] = {{"apple", 0, 0.840, 0.00, 0.02},   {"marble", 0, 0.804, 0.02, 0.04},
                          {"ketchup", 0, 0.145, 0.11, 0.15}, {"skin1", 1, 0.210, 0.07, 0.16},
                          {"skin1", 2, 0.114, 0.07, 0.16},   {"skin2", 1, 0.429, 0.0, 0.16}};
    for (const auto& [material, channel, exact, low, high] : cases) {
        const auto kernel = dipoles(renderer::measured_medium(material).value())[channel];
        const double excess = plane_total(kernel) / exact - 1;
        EXPECT_GE(excess, low) << material << ' ' << channel;
        EXPECT_LE(excess, high) << material << ' ' << channel;
    }
}

} // namespace
