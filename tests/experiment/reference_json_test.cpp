// The stable forms of `reference` and `compare`.
#include "experiment/energy_json.h"
#include "experiment/errors_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace {

using namespace experiment;
using renderer::reference::Incidence;

renderer::reference::EnergyBalance balance() {
    renderer::reference::EnergyBalance b;
    b.back = {0.25, 0.001};
    b.through = {0.5, 0.002};
    b.escape = {0.75, 0.003};
    b.specular = 0.04;
    return b;
}

TEST(EnergyJson, HasTheStableFormOfASlab) {
    const auto json =
        nlohmann::json::parse(energy_json(balance(), EnergyShape::Slab, Incidence::Normal, 1.5));
    EXPECT_EQ(json["reflectance"]["estimate"], 0.25);
    EXPECT_EQ(json["reflectance"]["standard_error"], 0.001);
    EXPECT_EQ(json["transmittance"]["estimate"], 0.5);
    EXPECT_EQ(json["specular"], 0.04);
    EXPECT_EQ(json["seconds"], 1.5);
    EXPECT_FALSE(json.contains("escape"));
}

TEST(EnergyJson, HasEscapeForASphere) {
    const auto json =
        nlohmann::json::parse(energy_json(balance(), EnergyShape::Sphere, Incidence::Diffuse, 1));
    EXPECT_EQ(json["escape"]["estimate"], 0.75);
    EXPECT_FALSE(json.contains("reflectance"));
    EXPECT_FALSE(json.contains("forward"));
    const auto beam =
        nlohmann::json::parse(energy_json(balance(), EnergyShape::Sphere, Incidence::Normal, 1));
    EXPECT_EQ(beam["forward"]["estimate"], 0.5);
}

TEST(ErrorsJson, HasEveryMeasureUnderItsName) {
    Comparison comparison;
    comparison.raw = {1, 2, 3, std::numeric_limits<double>::infinity(), 5, 6, 7, {}};
    comparison.equalised = comparison.raw;
    comparison.gain = 2;
    const auto json = nlohmann::json::parse(errors_json(comparison));
    EXPECT_EQ(json["RMSE"], 1);
    EXPECT_EQ(json["MAE"], 2);
    EXPECT_EQ(json["relMSE"], 3);
    EXPECT_EQ(json["PSNR"], "inf");
    EXPECT_EQ(json["SSIM"], 5);
    EXPECT_EQ(json["LDR-FLIP"], 6);
    EXPECT_EQ(json["HDR-FLIP"], 7);
    EXPECT_EQ(json["equalised"]["gain"], 2);
    EXPECT_FALSE(json.contains("noise_floor"));
    comparison.noise_floor = comparison.raw;
    EXPECT_TRUE(nlohmann::json::parse(errors_json(comparison)).contains("noise_floor"));
    EXPECT_THAT(errors_text(comparison), testing::HasSubstr("noise floor"));
}

} // namespace
