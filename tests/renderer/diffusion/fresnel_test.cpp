#include "renderer/diffusion/fresnel.h"

#include <cmath>

namespace {

using namespace renderer::diffusion;

struct Row {
    double eta, normal, external, internal; // F0, F_ext, F_dr
};

// Computed with an independent quadrature; half a unit of the last printed digit.
const Row rows[] = {{1.30, 0.017013, 0.0611318, 0.4444567},
                    {1.33, 0.020059, 0.0659308, 0.4719491},
                    {1.40, 0.027778, 0.0768115, 0.5289855},
                    {1.50, 0.040000, 0.0917780, 0.5963458}};

TEST(Fresnel, TabulatedMeansToTheirPrintedDigits) {
    for (const auto& row : rows) {
        EXPECT_NEAR(fresnel_reflectance(1, row.eta), row.normal, 0.5e-6) << row.eta;
        EXPECT_NEAR(external_diffuse_reflectance(row.eta), row.external, 0.5e-7) << row.eta;
        EXPECT_NEAR(internal_diffuse_reflectance(row.eta), row.internal, 0.5e-7) << row.eta;
    }
}

// The paper's fit F_dr = -1.440/eta^2 + 0.710/eta + 0.668 + 0.0636 eta is within 0.001 of the exact
// mean in its range, so the two check each other.
TEST(Fresnel, InternalMeanIsWhatThePaperFitted) {
    for (const auto& [eta, normal, external, internal] : rows) {
        const double fit = -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta;
        EXPECT_NEAR(internal_diffuse_reflectance(eta), fit, 1e-3) << eta;
    }
}

// Inside and outside are one boundary seen from two sides.
TEST(Fresnel, SwappingTheSidesInvertsTheIndex) {
    for (const double eta : {1.001, 1.3, 1.5, 2.4}) {
        EXPECT_NEAR(external_diffuse_reflectance(1 / eta), internal_diffuse_reflectance(eta),
                    1e-14);
        EXPECT_NEAR(internal_diffuse_reflectance(1 / eta), external_diffuse_reflectance(eta),
                    1e-14);
    }
}

TEST(Fresnel, WithoutABoundaryNothingIsReflected) {
    for (const double cosine : {0.0, 1e-300, 0.5, 1.0})
        EXPECT_EQ(fresnel_reflectance(cosine, 1), 0);
    EXPECT_EQ(external_diffuse_reflectance(1), 0);
    EXPECT_EQ(internal_diffuse_reflectance(1), 0);
    // and a boundary that is nearly none reflects nearly nothing
    EXPECT_LE(internal_diffuse_reflectance(1 + 1e-9), 1e-6);
    EXPECT_GE(internal_diffuse_reflectance(1 + 1e-9), 0);
}

TEST(Fresnel, IsBetweenZeroAndOneAndContinuousAtTheCriticalAngle) {
    const double eta = 1 / 1.5, critical = std::sqrt(1 - eta * eta);
    EXPECT_EQ(fresnel_reflectance(std::nextafter(critical, 0.0) - 1e-15, eta), 1);
    EXPECT_NEAR(fresnel_reflectance(std::nextafter(critical, 1.0), eta), 1, 1e-3);
    for (double mu = 0; mu <= 1; mu += 1.0 / 64) {
        EXPECT_GE(fresnel_reflectance(mu, 1.5), 0.04 - 1e-15);
        EXPECT_LE(fresnel_reflectance(mu, 1.5), 1);
    }
}

} // namespace
