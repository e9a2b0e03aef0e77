// Pictures and numbers of the reference, and comparisons with it, as a script asks for them.
#include "tests/end_to_end/program.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

namespace {

namespace fs = std::filesystem;
using namespace tests;
using testing::HasSubstr;

nlohmann::json json_of(const fs::path& file) {
    return nlohmann::json::parse(read_file(file));
}

// MCML's first check: 0.0973946 and 0.6609577; 4 standard errors, fixed seed.
TEST(ReferenceCommand, PrintsASlabAsTheTablesHaveIt) {
    const TemporaryFolder folder;
    const auto file = folder / "slab.json";
    const auto run = pairlight({"reference", "slab", "--albedo", "0.9", "--anisotropy", "0.75",
                                "--optical-thickness", "2", "--index", "1", "--paths", "100000",
                                "--seed", "3", "--json", file.string()});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto json = json_of(file);
    for (const auto& [name, exact] :
         {std::pair{"reflectance", 0.0973946}, {"transmittance", 0.6609577}}) {
        const double error = json[name]["standard_error"];
        EXPECT_LE(std::abs(json[name]["estimate"].get<double>() - exact), 4 * error) << name;
        EXPECT_LE(error, 0.01 * exact) << name;
    }
    EXPECT_EQ(json["specular"], 0);
    EXPECT_GT(json["seconds"], 0);
}

TEST(ReferenceCommand, GivesTheSameNumbersForTheSameSeed) {
    const auto once = [](const std::string& seed) {
        auto run = pairlight({"reference", "sphere", "--albedo", "0.9", "--index", "1.4", "--paths",
                              "10000", "--seed", seed, "--json", "-"});
        auto json = nlohmann::json::parse(run.out);
        json.erase("seconds");
        return json;
    };
    EXPECT_EQ(once("1"), once("1"));
    EXPECT_NE(once("1"), once("2"));
}

std::vector<std::string> torus(const fs::path& out, const std::string& seed = "1") {
    return {"reference",        "torus", "--diameter-mm", "4",  "--size", "24",
            "--relative-error", "0.3",   "--seed",        seed, "--out",  out.string()};
}

TEST(ReferenceCommand, MakesAPictureThatIsGoneOnWithAndCompared) {
    const TemporaryFolder folder;
    const auto file = folder / "torus.exr", other = folder / "other.exr";
    auto run = pairlight(torus(file));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("0 leaks"));
    run = pairlight(torus(file)); // done already: read, found good, written again
    ASSERT_EQ(run.status, 0) << run.err;
    auto refused = torus(file);
    refused[3] = "5";
    run = pairlight(refused);
    EXPECT_NE(run.status, 0);
    EXPECT_THAT(run.err, HasSubstr("is a reference of something else"));

    ASSERT_EQ(pairlight(torus(other, "2")).status, 0);
    const auto result = folder / "errors.json";
    run = pairlight({"compare", file.string(), other.string(), "--json", result.string(), "--maps",
                     (folder / "map").string()});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto errors = json_of(result);
    for (const char* name : {"RMSE", "MAE", "relMSE", "PSNR", "SSIM", "LDR-FLIP", "HDR-FLIP"}) {
        EXPECT_TRUE(errors.contains(name)) << name;
        EXPECT_TRUE(errors["equalised"].contains(name)) << name;
        EXPECT_TRUE(errors["noise_floor"].contains(name)) << name;
    }
    // halves have twice the variance of the whole: sqrt(2) apart as two wholes are, twice the rest
    EXPECT_LT(errors["RMSE"].get<double>(), 2 * errors["noise_floor"]["RMSE"].get<double>());
    for (const char* map : {"map-flip.png", "map-ssim.png", "map-relative.png"})
        EXPECT_TRUE(fs::exists(folder / map)) << map;

    run = pairlight({"compare", file.string(), file.string(), "--json", result.string()});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(json_of(result)["PSNR"], "inf");
    EXPECT_EQ(json_of(result)["RMSE"], 0);
}

TEST(ReferenceCommand, SaysWhatCannotBe) {
    const TemporaryFolder folder;
    auto polished = torus(folder / "a.exr");
    polished.insert(polished.end(), {"--boundary", "smooth"});
    EXPECT_THAT(pairlight(polished).err, HasSubstr("expected at least 2 degrees"));
    EXPECT_THAT(pairlight({"reference", "torus"}).err, HasSubstr("--out"));
    EXPECT_NE(pairlight({"reference", "slab", "--albedo", "1.5"}).status, 0);
    EXPECT_THAT(pairlight({"reference", "torus", "--scene", "x", "--out", "x.exr"}).err,
                HasSubstr("--scene: is for a study; torus is a model"));
    auto rough = torus(folder / "a.exr");
    rough.insert(rough.end(), {"--roughness", "0.5"});
    EXPECT_THAT(pairlight(rough).err, HasSubstr("--roughness: is of a rough boundary"));
    EXPECT_FALSE(fs::exists(folder / "a.exr"));
    const auto straight =
        pairlight({"reference", "slab", "--boundary", "matched", "--index", "1.5"});
    EXPECT_NE(straight.status, 0);
    EXPECT_THAT(straight.err, HasSubstr("--index: bends no light through a matched boundary"));
    EXPECT_THAT(pairlight({"reference", "slab", "--roughness", "0.5"}).err,
                HasSubstr("--roughness: is of a rough boundary"));
    EXPECT_THAT(pairlight({"reference", "--size", "8", "slab"}).err,
                HasSubstr("--size is for a picture; leave it out beside slab"));
}

/// A torus, its methods, and its reference, which `session` may say more of.
void write_judged_study(const TemporaryFolder& folder, const std::string& session = "") {
    write_file(folder / "instructions.md", "# Welcome\n\nChoose.\n");
    write_file(folder / "study.toml", R"([study]
id       = "judged"
title    = "With its reference"
question = "Which picture looks more realistic?"
seed     = 1
width    = 32
height   = 32
[session]
warm_ups = 0
training = 0
)" + session + R"([[scene]]
id       = "body"
model    = "torus"
diameter_mm = 4
material = "marble"
[[condition]]
id     = "phong"
method = "phong"
[[condition]]
id     = "constant"
method = "constant"
[[condition]]
id     = "truth"
method = "reference"
relative_error = 0.3
)");
}

TEST(ReferenceCondition, IsRenderedBesideTheMethodsItJudges) {
    const TemporaryFolder folder;
    write_judged_study(folder);
    const auto run = pairlight({"render", folder.path().string()});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(fs::exists(folder.path() / "stimuli" / "body" / "truth.png"));
    EXPECT_THAT(read_file(folder.path() / "stimuli" / "manifest.json"), HasSubstr("path tracer"));
    const auto asked =
        pairlight({"schedule", folder.path().string(), "--observer", "P1", "--session", "1"});
    EXPECT_THAT(asked.out, HasSubstr("truth")) << asked.err; // a fifth contender, as it were
}

// In the middle it is what the two sides are judged against: rendered, shown, never asked about.
TEST(ReferenceCondition, CanStandInTheMiddle) {
    const TemporaryFolder folder;
    write_judged_study(folder, "reference = \"truth\"\n");
    const auto study = folder.path().string();
    auto run = pairlight({"render", study});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(fs::exists(folder.path() / "stimuli" / "body" / "truth.png"));
    run = pairlight({"check", study});
    EXPECT_THAT(run.out + run.err, HasSubstr("one of them the reference"));
    run = pairlight({"session", study, "--observer", "P1", "--simulate", ""});
    ASSERT_EQ(run.status, 0) << run.err;
    run = pairlight({"export", study, "--format", "long"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, testing::AllOf(HasSubstr("phong"), HasSubstr("constant"),
                                        testing::Not(HasSubstr("truth"))));
}

/// A sphere without its lower end: an opening as wide as `share` of the way leaves it.
std::string bowl(double share) {
    constexpr int rows = 12, columns = 24;
    std::string vertices = "0 0 1\n", faces;
    for (int i = 1; i <= rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double down = M_PI * share * i / rows, round = 2 * M_PI * j / columns;
            vertices += fmt::format("{} {} {}\n", std::sin(down) * std::cos(round),
                                    std::sin(down) * std::sin(round), std::cos(down));
            const int a = 1 + (i - 1) * columns + j, b = a - j + (j + 1) % columns;
            faces += i == 1 ? fmt::format("3 0 {} {}\n", a, b)
                            : fmt::format("3 {} {} {}\n3 {} {} {}\n", a - columns, a, b,
                                          a - columns, b, b - columns);
        }
    return fmt::format("OFF\n{} {} 0\n", 1 + rows * columns, columns * (2 * rows - 1)) + vertices +
           faces;
}

// That paths leak is no fault of a closed mesh here, and nothing but closing it helps.
TEST(ReferenceCommand, SaysThatABodyIsTooOpenToFollowLightIn) {
    const TemporaryFolder folder;
    write_file(folder / "bowl.off", bowl(0.5));
    const auto seen_from = [&](const char* degrees) {
        return pairlight({"reference", (folder / "bowl.off").string(), "--holes", "winding",
                          "--size", "48", "--diameter-mm", "10", "--turn-degrees", degrees,
                          "--seconds", "1", "--out", (folder / "bowl.exr").string()});
    };
    for (const auto* degrees : {"0", "180"}) {
        const auto outcome = seen_from(degrees);
        EXPECT_EQ(outcome.status, 1) << degrees;
        EXPECT_THAT(outcome.err, HasSubstr("its surface is open (24 boundary edges, the first "));
        EXPECT_THAT(outcome.err, HasSubstr("; close it in a mesh editor"));
        EXPECT_FALSE(fs::exists(folder / "bowl.exr"));
    }
}

} // namespace
