#include "experiment/materials.h"
#include "renderer/materials.h"

namespace {

using namespace experiment;

protocols::Scene made_of(const std::string& material) {
    protocols::Scene scene;
    scene.material = material;
    return scene;
}

protocols::Study study() {
    protocols::Study study;
    study.materials = {
        {.id = {"stone"},
         .medium = protocols::Coefficients{{0.0021, 0.0041, 0.0071}, {2.19, 2.62, 3.00}, 1.5}},
        {.id = {"wax"}, .medium = protocols::Colour{{0.8, 0.7, 0.5}, {4, 2, 1}}}};
    return study;
}

TEST(SceneMaterial, IsTheMeasuredOneOfItsName) {
    const auto marble = material_of(study(), made_of("marble"));
    ASSERT_TRUE(marble);
    EXPECT_EQ(marble->medium.sigma_a, renderer::measured_medium("marble")->sigma_a);
    EXPECT_FALSE(material_of(study(), made_of("granite")));
}

TEST(SceneMaterial, OfMarblesCoefficientsIsMarble) {
    const auto stone = material_of(study(), made_of("stone"));
    const auto marble = renderer::measured_material("marble");
    ASSERT_TRUE(stone);
    EXPECT_EQ(stone->medium.sigma_a, marble->medium.sigma_a);
    EXPECT_EQ(stone->medium.sigma_s_reduced, marble->medium.sigma_s_reduced);
    EXPECT_EQ(stone->medium.index, 1.5);
    EXPECT_EQ(stone->reflectance.diffuse, marble->reflectance.diffuse);
}

TEST(SceneMaterial, OfAColourHasThatColourAndSpreadsLightAsFarAsAsked) {
    const auto wax = material_of(study(), made_of("wax"));
    ASSERT_TRUE(wax);
    EXPECT_EQ(wax->reflectance.diffuse, (renderer::LinearRgb{0.4F, 0.35F, 0.25F}));
    EXPECT_EQ(wax->reflectance.scatter, wax->reflectance.diffuse);
    EXPECT_EQ(wax->medium.index, 1);
    const auto& m = wax->medium;
    // 1/sigma_t = d (1.9 - A + 3.5 (A - 0.8)^2)
    EXPECT_NEAR(1 / (m.sigma_a.r + m.sigma_s_reduced.r), 4 * 1.1, 1e-6);
    EXPECT_NEAR(1 / (m.sigma_a.g + m.sigma_s_reduced.g), 2 * 1.235, 1e-6);
    EXPECT_NEAR(1 / (m.sigma_a.b + m.sigma_s_reduced.b), 1 * 1.715, 1e-6);
}

} // namespace
