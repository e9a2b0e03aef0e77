#include "renderer/materials.h"

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

TEST(MeasuredMaterials, SendBackTheirReflectanceWhenTheyFaceTheLight) {
    for (const auto& name : measured_names()) {
        const auto k = measured_material(name)->reflectance;
        EXPECT_EQ(k.diffuse, k.scatter);
        EXPECT_FLOAT_EQ(k.ambient.g, 0.05F * k.diffuse.g);
        EXPECT_LT(k.diffuse.r + k.scatter.r, 1);
    }
    const auto marble = measured_material("marble")->reflectance;
    EXPECT_FLOAT_EQ(marble.diffuse.g + marble.scatter.g, 0.768F);
}

} // namespace
