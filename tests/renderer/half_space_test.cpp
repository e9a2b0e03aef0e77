#include "renderer/half_space.h"

#include <vector>

namespace {

using namespace renderer;

struct Row {
    double index, albedo, normal, diffuse;
};

// Index-matched: 1 - H(1) sqrt(1 - a) and its mean over diffuse light, H by the explicit integral
// in arbitrary precision.  With a surface: adding-doubling, and the same integral equation by
// another quadrature; both agree to the seven digits printed here.
const std::vector<Row> tabulated{
    {1, 0.5, 0.115225878, 0.146544381},
    {1, 0.7, 0.208679952, 0.256556653},
    {1, 0.9, 0.414947479, 0.478024489},
    {1, 0.95, 0.535540989, 0.596668780},
    {1, 0.99, 0.752720717, 0.794563653},
    {1, 0.999, 0.912845335, 0.929713285},
    {1, 1, 1, 1},
    {1.3, 0.9, 0.2857828, 0.2883341},
    {1.3, 0.99, 0.6453937, 0.6305512},
    {1.3, 0.999, 0.8567544, 0.8247878},
    {1.3, 1, 0.9829868, 0.9388682},
    {1.4, 0.9, 0.2505959, 0.2489355},
    {1.4, 0.99, 0.6035893, 0.5840070},
    {1.5, 0.5, 0.0442459, 0.0443435},
    {1.5, 0.9, 0.2199186, 0.2161121},
    {1.5, 0.99, 0.5619808, 0.5401830},
    {1.5, 0.999, 0.8014585, 0.7624620},
};

TEST(HalfSpace, SendsBackWhatTransportTheorySays) {
    for (const auto& [index, albedo, normal, diffuse] : tabulated) {
        EXPECT_NEAR(body_reflectance(albedo, index, Incidence::Normal), normal, 6e-8)
            << index << ' ' << albedo; // half of the last digit printed
        EXPECT_NEAR(body_reflectance(albedo, index, Incidence::Diffuse), diffuse, 6e-8)
            << index << ' ' << albedo;
    }
}

// With no absorption all light comes back: what the surface does not mirror, the body sends.
// (1.5 - 1)^2/(1.5 + 1)^2 = 0.04 and the hemispherical mean 0.0917780 of the Fresnel reflectance.
TEST(HalfSpace, WithoutAbsorptionSendsBackAllThatEnters) {
    EXPECT_NEAR(body_reflectance(1, 1.5, Incidence::Normal), 1 - 0.04, 1e-7);
    EXPECT_NEAR(body_reflectance(1, 1.5, Incidence::Diffuse), 1 - 0.0917780, 1e-7);
}

TEST(HalfSpace, WithoutScatteringIsBlack) {
    EXPECT_EQ(body_reflectance(0, 1.3, Incidence::Normal), 0);
    EXPECT_EQ(body_reflectance(0, 1, Incidence::Diffuse), 0);
}

TEST(HalfSpace, OfNoSurfaceIsTheLimitOfAFaintOne) {
    EXPECT_NEAR(body_reflectance(0.9, 1.000001, Incidence::Normal),
                body_reflectance(0.9, 1, Incidence::Normal), 1e-5);
}

TEST(HalfSpaceDeathTest, HasPossibleCoefficients) {
    EXPECT_DEATH(body_reflectance(1.1, 1.3, Incidence::Normal), "albedo");
    EXPECT_DEATH(body_reflectance(0.5, 0.9, Incidence::Normal), "index");
}

} // namespace
