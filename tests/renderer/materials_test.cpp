#include "renderer/half_space.h"
#include "renderer/materials.h"

#include <array>
#include <cmath>
#include <map>

namespace {

using namespace renderer;

TEST(MeasuredMaterials, AreTwelveInAlphabeticalOrder) {
    EXPECT_THAT(measured_names(),
                testing::ElementsAre("apple", "chicken1", "chicken2", "cream", "ketchup", "marble",
                                     "potato", "skim-milk", "skin1", "skin2", "spectralon",
                                     "whole-milk"));
    EXPECT_FALSE(measured_medium("granite"));
    EXPECT_FALSE(measured_material("Marble"));
}

// Diffusion lengths 1/sigma_tr as tabulated beside the coefficients, to three digits: a misprint in
// either column would show.
TEST(MeasuredMaterials, HaveTheirDiffusionLengths) {
    const std::map<std::string, std::array<double, 3>> tabulated{
        {"apple", {6.96, 6.40, 1.90}},      {"chicken1", {11.6, 3.88, 1.75}},
        {"chicken2", {9.44, 3.35, 1.79}},   {"cream", {15.0, 4.66, 2.54}},
        {"ketchup", {4.76, 0.575, 0.394}},  {"marble", {8.51, 5.57, 3.95}},
        {"potato", {14.3, 7.23, 2.04}},     {"skim-milk", {18.4, 10.4, 3.50}},
        {"skin1", {3.67, 1.37, 0.683}},     {"skin2", {4.82, 1.69, 1.09}},
        {"whole-milk", {10.9, 6.58, 2.51}},
    };
    EXPECT_EQ(tabulated.size() + 1, measured_names().size()); // spectralon's is infinite
    for (const auto& [name, lengths] : tabulated) {
        const auto sigma_tr = effective_transport(measured_medium(name).value());
        EXPECT_NEAR(1 / sigma_tr.r / lengths[0], 1, 0.005) << name;
        EXPECT_NEAR(1 / sigma_tr.g / lengths[1], 1, 0.005) << name;
        EXPECT_NEAR(1 / sigma_tr.b / lengths[2], 1, 0.005) << name;
    }
}

TEST(MeasuredMaterials, DoNotAbsorbInSpectralon) {
    EXPECT_EQ(measured_medium("spectralon")->sigma_a, (RgbPerMillimetre{0, 0, 0}));
}

// Body reflectance of a thick layer at normal incidence, tabulated beside the coefficients to three
// places (two digits where it is below 0.01).  Half of the last digit is rounding; the table's own
// quadrature leaves another tenth (ours is good to 1e-6: half_space_test).
TEST(MeasuredMaterials, HaveTheirExactReflectances) {
    const std::map<std::string, std::array<double, 3>> tabulated{
        {"apple", {0.840, 0.835, 0.528}},      {"chicken1", {0.301, 0.137, 0.109}},
        {"chicken2", {0.310, 0.141, 0.092}},   {"cream", {0.961, 0.891, 0.724}},
        {"ketchup", {0.145, 0.0053, 0.0015}},  {"marble", {0.804, 0.768, 0.731}},
        {"potato", {0.762, 0.614, 0.195}},     {"skim-milk", {0.811, 0.809, 0.683}},
        {"skin1", {0.432, 0.210, 0.114}},      {"skin2", {0.624, 0.429, 0.333}},
        {"spectralon", {0.983, 0.983, 0.983}}, {"whole-milk", {0.898, 0.873, 0.758}},
    };
    EXPECT_EQ(tabulated.size(), measured_names().size());
    for (const auto& [name, R] : tabulated) {
        const auto k = measured_material(name).value().reflectance;
        const auto expect = [&](float diffuse, float scatter, double printed) {
            const double last_digit = printed < 0.01 ? 1e-4 : 1e-3;
            EXPECT_NEAR(static_cast<double>(diffuse + scatter), printed, 0.6 * last_digit) << name;
        };
        expect(k.diffuse.r, k.scatter.r, R[0]);
        expect(k.diffuse.g, k.scatter.g, R[1]);
        expect(k.diffuse.b, k.scatter.b, R[2]);
    }
}

TEST(Preset, HalvesTheReflectanceBetweenDiffuseAndScatteredLight) {
    const auto k = preset({0.8F, 0.4F, 0.2F});
    EXPECT_EQ(k.diffuse, (LinearRgb{0.4F, 0.2F, 0.1F}));
    EXPECT_EQ(k.scatter, k.diffuse);
    EXPECT_FLOAT_EQ(k.ambient.r, 0.02F);
    EXPECT_FLOAT_EQ(k.ambient.b, 0.005F);
    EXPECT_EQ(k.specular, (LinearRgb{0.04F, 0.04F, 0.04F}));
    EXPECT_EQ(k.shininess, 32);
}

TEST(OwnCoefficients, OfAMeasuredMaterialMakeThatMaterial) {
    const auto own = material_of({{0.0021, 0.0041, 0.0071}, {2.19, 2.62, 3.00}, 1.5});
    const auto marble = measured_material("marble").value();
    EXPECT_EQ(own.reflectance.diffuse, marble.reflectance.diffuse);
    EXPECT_EQ(own.medium.sigma_a, marble.medium.sigma_a);
}

TEST(OwnCoefficientsDeathTest, HaveSomethingInEveryChannel) {
    EXPECT_DEATH(material_of({{1, 0, 1}, {1, 0, 1}, 1.3}), "sigma_a");
}

// By hand, colour 0.8 at d = 2 mm: 1.9 - 0.8 = 1.1, so sigma_t = 1/2.2; the exponent is
// -4.075248 + 1.6716032 - 2.2108416 = -4.6144864, so 1 - albedo = 0.00990727.
TEST(Colour, IsInvertedAsPublished) {
    const auto medium =
        medium_of_colour({0.8F, 0.8F, 0.8F}, {Millimetres{2}, Millimetres{2}, Millimetres{4}});
    EXPECT_NEAR(medium.sigma_a.r, 0.00990727 / 2.2, 1e-8);
    EXPECT_NEAR(medium.sigma_s_reduced.r, 0.99009273 / 2.2, 1e-7);
    EXPECT_NEAR(medium.sigma_a.b, medium.sigma_a.g / 2, 1e-12);
    EXPECT_EQ(medium.index, 1);
}

// The published fit against transport theory: how well a thick layer of the inverted medium has the
// colour in diffuse light that was asked for.
TEST(Colour, IsThatOfAThickLayerInDiffuseLight) {
    const auto error = [](double A) {
        const auto colour = static_cast<float>(A);
        const auto medium = medium_of_colour({colour, colour, colour},
                                             {Millimetres{1}, Millimetres{1}, Millimetres{1}});
        const double albedo =
            medium.sigma_s_reduced.r / (medium.sigma_a.r + medium.sigma_s_reduced.r);
        return body_reflectance(albedo, 1, Incidence::Diffuse) - A;
    };
    for (int i = 0; i <= 16; ++i)
        EXPECT_LE(std::abs(error(0.05 * i)), 0.007) << 0.05 * i;
    EXPECT_NEAR(error(0.9), -0.030, 0.001); // as the header says
    EXPECT_NEAR(error(1), -0.074, 0.001);
}

} // namespace
