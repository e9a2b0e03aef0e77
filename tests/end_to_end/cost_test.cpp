// pairlight cost, from outside, on a ring of 512 vertices.
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/off_file.h"
#include "tests/end_to_end/program.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace {

namespace fs = std::filesystem;
using namespace tests;
using nlohmann::json;
using testing::HasSubstr;

constexpr const char* study_text = R"([study]
id       = "costs"
title    = "A torus"
question = "Which?"
seed     = 3
width    = 64
height   = 64
[[scene]]
id          = "torus"
model       = "ring.off"
material    = "marble"
diameter_mm = 40
[[variant]]
id       = "back"
to_light = [0, 0.3, -1]
[[variant]]
id       = "front"
to_light = [0, 0.3, 1]
[[condition]]
id     = "auto"
method = "shss"
bands  = "auto"
tolerance = 0.02
[[condition]]
id     = "phong"
method = "phong"
)";

class CostCommand : public testing::Test {
  protected:
    void SetUp() override {
        write_file(folder_ / "study.toml", study_text);
        write_file(folder_ / "ring.off",
                   renderer::geometry::off_text(renderer::geometry::torus(0.7, 0.3, 32, 16)));
    }

    Outcome cost(std::vector<std::string> more) const {
        std::vector<std::string> command{"cost", folder_.path().string(), "--rounds", "2", "--size",
                                         "48"};
        command.insert(command.end(), more.begin(), more.end());
        return pairlight(command);
    }

    Outcome cost_from(const std::string& file, std::vector<std::string> more) const {
        more.insert(more.begin(), {"cost", folder_.path().string(), "--from", file});
        return pairlight(more);
    }

    json report() const { return json::parse(read_file(folder_ / "cost/cost.json")); }

    static const json&
    row(const json& scene, const std::string& method, const std::string& setting) {
        return *std::ranges::find_if(scene["rows"], [&](const json& one) {
            return one["method"] == method && one["setting"] == setting;
        });
    }

    TemporaryFolder folder_;
};

TEST_F(CostCommand, MeasuresComparesChoosesAndWrites) {
    const auto done = cost({"--methods", "shss", "traced", "phong", "--held-out", "2",
                            "--reference-seconds", "1", "--tolerance", "0.2"});
    ASSERT_EQ(done.status, 0) << done.err;
    for (const auto* file : {"cost.csv", "cost.html", "figures/cost-torus-back.svg",
                             "figures/cost-torus-front.pdf", "reference/torus/back.exr"})
        EXPECT_TRUE(fs::exists(folder_ / "cost" / file)) << file;
    const auto scene = report()["scenes"][0];
    EXPECT_EQ(scene["lights"].size(), 2U);
    const auto& five = row(scene, "shss", "");
    const auto& one = row(scene, "shss", "bands 1");
    EXPECT_EQ(five["bytes_per_vertex"], 100);
    EXPECT_GT(five["precompute_seconds"].get<double>(), 0);
    EXPECT_GT(five["frame_ms"]["median"].get<double>(), 0);
    // one number for all directions tells less than 25 coefficients
    EXPECT_LT(five["thickness"].get<double>(), one["thickness"].get<double>());
    EXPECT_LT(five["lights"][0]["law"].get<double>(), one["lights"][0]["law"].get<double>());
    EXPECT_EQ(row(scene, "traced", "")["thickness"], 0.0);
    EXPECT_EQ(row(scene, "traced", "")["lights"][0]["law"], 0.0);
    EXPECT_FALSE(row(scene, "phong", "").contains("thickness"));
    EXPECT_FALSE(row(scene, "phong", "")["lights"][0].contains("law"));
    EXPECT_GT(row(scene, "phong", "")["lights"][0]["fitted"].get<double>(), 0);
    EXPECT_GT(scene["lights"][0]["noise_floor"].get<double>(), 0);
    // half of the ring: fewer vertices, and another surface than the one it is measured by
    const auto& half = row(scene, "traced", "triangles 1/2");
    EXPECT_EQ(scene["triangles"], 1024);
    EXPECT_EQ(half["triangles"], 512);
    EXPECT_EQ(half["vertices"], 256);
    EXPECT_LT(half["mesh_bytes"].get<int>(), row(scene, "traced", "")["mesh_bytes"].get<int>());
    for (const double error :
         {half["thickness"].get<double>(), half["lights"][0]["law"].get<double>()}) {
        EXPECT_GT(error, 0);
        EXPECT_LT(error, 0.5);
    }
    EXPECT_GT(row(scene, "phong", "triangles 1/8")["lights"][0]["fitted"].get<double>(), 0);
    EXPECT_THAT(read_file(folder_ / "cost/cost.csv"), HasSubstr("torus,back,shss,triangles 1/4,"));
    EXPECT_THAT(read_file(folder_ / "cost/cost.html"), HasSubstr("SHSS, triangles 1/4"));
    const auto& choice = scene["lights"][0]["choice"];
    EXPECT_LE(choice["predicted"].get<double>(), 0.2);
    EXPECT_LE(choice["measured"].get<double>(), 0.3);
    EXPECT_THAT(done.out, HasSubstr("Chosen: **" + choice["setting"].get<std::string>() + "**"));
    EXPECT_THAT(done.out, HasSubstr("Left out: "));

    // chosen from again: the most exact there is, and nothing measured anew
    const auto first = (folder_ / "cost/cost.json").string();
    const auto again =
        cost_from(first, {"--tolerance", "0.000001", "--out", (folder_ / "again").string()});
    ASSERT_EQ(again.status, 0) << again.err;
    const auto other = json::parse(read_file(folder_ / "again/cost.json"))["scenes"][0];
    EXPECT_EQ(other["rows"], scene["rows"]);
    EXPECT_EQ(other["lights"][0]["choice"]["setting"], "Traced thickness");

    const auto refused = [&](std::vector<std::string> words, const std::string& why) {
        const auto outcome = cost_from(first, std::move(words));
        EXPECT_NE(outcome.status, 0) << why;
        EXPECT_THAT(outcome.err, HasSubstr(why));
    };
    refused({"--from", first}, "is in an earlier --from already");
    refused({"--rounds", "3"}, "--rounds: nothing is measured with --from");
    refused({"--scene", "torus"}, "--scene: nothing is measured with --from");
    const auto of_another = pairlight({"cost", "torus", "--from", first});
    EXPECT_NE(of_another.status, 0);
    EXPECT_THAT(
        of_another.err,
        HasSubstr("cost.json: measured is \"A torus\", and torus is \"torus\"; expected the "
                  "name of what was measured"));
    write_file(folder_ / "damaged.json", read_file(first).substr(0, 2000));
    const auto damaged = cost_from((folder_ / "damaged.json").string(), {});
    EXPECT_NE(damaged.status, 0);
    EXPECT_THAT(damaged.err,
                HasSubstr("the JSON ends before it is complete; expected a cost.json"));
    // another report than the one it is made from is not replaced
    fs::create_directories(folder_ / "other");
    fs::copy_file(first, folder_ / "other/cost.json");
    refused({"--out", (folder_ / "other").string()}, "would be lost");
    EXPECT_EQ(cost_from(first, {"--tolerance", "0.3"}).status, 0); // its own is
}

// An open ring: inside is where the surface winds more than half around, if a scene says so.
TEST_F(CostCommand, TakesAModelWithHolesWhereItIsToldTo) {
    auto ring = renderer::geometry::torus(0.7, 0.3, 32, 16);
    ring.triangles.pop_back();
    const auto file = (folder_ / "open.off").string();
    write_file(file, renderer::geometry::off_text(ring));
    const std::vector<std::string> command{
        "cost",   file, "--methods",           "phong", "--rounds",   "1",
        "--size", "32", "--frame-size",        "32",    "--to-light", "0",
        "0.3",    "-1", "--reference-seconds", "0",     "--out",      (folder_ / "open").string()};
    EXPECT_THAT(pairlight(command).err, HasSubstr("boundary edges"));
    auto told = command;
    told.insert(told.end(), {"--holes", "winding"});
    const auto done = pairlight(told);
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_THAT(done.out, HasSubstr("triangles 1/2: not measured: only a closed manifold"));
}

TEST_F(CostCommand, UsesAPathTracedPictureThatIsThere) {
    fs::create_directories(folder_ / "reference/torus");
    for (const std::string variant : {"back", "front"})
        ASSERT_EQ(
            pairlight({"reference", folder_.path().string(), "--variant", variant, "--seconds", "1",
                       "--out", (folder_ / ("reference/torus/" + variant + ".exr")).string()})
                .status,
            0);
    const auto done = cost({"--methods", "phong", "--presets", "--error", "fitted",
                            "--frame-budget", "1000", "--variant", "back"});
    ASSERT_EQ(done.status, 0) << done.err;
    const auto light = report()["scenes"][0]["lights"][0];
    EXPECT_EQ(light["width"], 64); // the study's, whatever --size says
    EXPECT_THAT(light["reference"].get<std::string>(), HasSubstr("reference/torus/back.exr"));
    EXPECT_FALSE(fs::exists(folder_ / "cost/reference"));
    EXPECT_FALSE(light["choice"].contains("measured"));
}

TEST_F(CostCommand, SaysWhatCannotBe) {
    EXPECT_THAT(cost({"--methods", "shs"}).err, HasSubstr("--methods shs: no method is called so"));
    EXPECT_THAT(cost({"--scene", "cube"}).err, HasSubstr("no scene \"cube\""));
    EXPECT_THAT(cost({"--variant", "top"}).err, HasSubstr("no variant \"top\""));
    EXPECT_THAT(cost({"--tolerance", "nan"}).err, HasSubstr("nan is not a number from"));
    EXPECT_THAT(cost({"--tolerance", "0.1", "--frame-budget", "3"}).err,
                HasSubstr("expected one of them"));
    for (const auto& words : std::vector<std::vector<std::string>>{
             {"--methods", "shs"}, {"--scene", "cube"}, {"--error", "speed"}, {"--rounds", "0"}})
        EXPECT_NE(cost(words).status, 0) << words[0];
    EXPECT_NE(pairlight({"cost", "no-such-model"}).status, 0);
    EXPECT_THAT(pairlight({"cost", ""}).err, HasSubstr("expected a study's folder or file, or a"));
    EXPECT_THAT(pairlight({"cost", "torus", "--to-light", "0", "0", "0"}).err,
                HasSubstr("--to-light 0 0 0: expected a direction"));
    EXPECT_THAT(cost({"--material", "skin1"}).err, HasSubstr("--material: is for a model; "));
    EXPECT_THAT(cost({"--holes", "winding"}).err, HasSubstr("--holes: is for a model; "));
    EXPECT_THAT(cost({"--presets", "--decimate", "2"}).err,
                HasSubstr("--decimate: --presets measures no simplified mesh"));
    EXPECT_NE(cost({"--decimate", "0"}).status, 0);
}

// Reckoned beforehand and measured afterwards, on a smooth body: within a fifth of each other.
TEST_F(CostCommand, TheManifestHasTheChoiceWithItsErrorReckonedAndMeasured) {
    const auto rendered = pairlight({"render", folder_.path().string()});
    ASSERT_EQ(rendered.status, 0) << rendered.err;
    const auto manifest = json::parse(read_file(folder_ / "stimuli/manifest.json"));
    int checked = 0;
    for (const auto& picture : manifest["pictures"]) {
        if (picture["condition"] != "auto") {
            EXPECT_FALSE(picture.contains("predicted_change"));
            continue;
        }
        EXPECT_THAT(picture["decision"].get<std::string>(), HasSubstr("bands"));
        EXPECT_LE(picture["predicted_change"].get<double>(), 0.02);
        EXPECT_LE(picture["measured_change"].get<double>(), 1.2 * 0.02);
        ++checked;
    }
    EXPECT_EQ(checked, 2);
}

} // namespace
