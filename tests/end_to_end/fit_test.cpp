// pairlight fit, from outside: targets that a method made itself are met by that method.
#include "tests/end_to_end/program.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace {

namespace fs = std::filesystem;
using namespace tests;
using nlohmann::json;
using testing::HasSubstr;

constexpr const char* study_text = R"([study]
id       = "fits"
title    = "A torus"
question = "Which?"
seed     = 3
width    = 64
height   = 64
[[scene]]
id          = "torus"
model       = "torus"
material    = "marble"
diameter_mm = 20
[[variant]]
id       = "back"
to_light = [0, 0.3, -1]
[[variant]]
id       = "left"
to_light = [-1, 0, 0.3]
[[variant]]
id       = "front"
to_light = [0, 0.3, 1]
[[condition]]
id         = "shss"
method     = "shss"
directions = 256
[[condition]]
id     = "phong"
method = "phong"
)";

class FitCommand : public testing::Test {
  protected:
    void SetUp() override { write_file(folder_ / "study.toml", study_text); }

    /// SHSS's own pictures become the targets.
    void render_targets() {
        ASSERT_EQ(pairlight({"render", folder_.path().string()}).status, 0);
        fs::create_directories(folder_ / "reference/torus");
        for (const std::string variant : {"back", "left", "front"})
            fs::copy_file(folder_ / ("stimuli/torus/" + variant + "/shss.exr"),
                          folder_ / ("reference/torus/" + variant + ".exr"));
    }

    TemporaryFolder folder_;
};

// The targets are half floats and have 16 samples a pixel, the fit takes 4: where the torus hides a
// part of itself within a pixel, the two differ.  That is 1e-6 of relMSE here.
TEST_F(FitCommand, GivesBackTheCoefficientsThatMadeTheTargets) {
    render_targets();
    const auto fitted = pairlight({"fit", folder_.path().string(), "--hold-out", "left", "--json",
                                   (folder_ / "fits.json").string()});
    ASSERT_EQ(fitted.status, 0) << fitted.err;
    const auto fits = json::parse(read_file(folder_ / "fits.json"));
    ASSERT_EQ(fits.size(), 2U);
    EXPECT_EQ(fits[0]["condition"], "shss");
    EXPECT_LE(fits[0]["training_relMSE"].get<double>(), 5e-6);
    EXPECT_LE(fits[0]["held_out_relMSE"].get<double>(), 5e-6);
    EXPECT_NEAR(fits[0]["specular"][0].get<double>(), 0.04, 5e-4); // the material's
    EXPECT_EQ(fits[1]["absent"], json::parse(R"(["scatter"])"));
    EXPECT_GT(fits[1]["held_out_relMSE"].get<double>(), 1e-3);
}

TEST_F(FitCommand, PrintsWhatAStudyFileCanHold) {
    render_targets();
    const auto fitted = pairlight({"fit", folder_.path().string()});
    ASSERT_EQ(fitted.status, 0) << fitted.err;
    const auto tables = fitted.out.substr(fitted.out.find("# condition \"phong\""));
    write_file(folder_ / "study.toml", study_text + tables); // behind the last [[condition]]
    const auto rendered = pairlight({"render", folder_.path().string()});
    EXPECT_EQ(rendered.status, 0) << rendered.err;
    EXPECT_THAT(rendered.out, HasSubstr("6 pictures rendered")); // the recipe has changed
}

TEST_F(FitCommand, SaysHowATargetIsMade) {
    const auto fitted = pairlight({"fit", folder_.path().string()});
    EXPECT_NE(fitted.status, 0);
    EXPECT_THAT(fitted.err, HasSubstr("reference/torus/back.exr: is not there"));
    EXPECT_THAT(fitted.err, HasSubstr("--scene torus --variant back --out"));
}

} // namespace
