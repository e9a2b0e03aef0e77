#include "tests/protocols/study_texts.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace {

using namespace study_texts;

TEST(StudyFile, TakesDefaultsForWhatItDoesNotSay) {
    const auto study = parsed(minimal);
    EXPECT_EQ(study.id, "pilot");
    EXPECT_EQ(study.seed, 7u);
    EXPECT_EQ(study.width, 320);
    EXPECT_EQ(study.height, 240);
    EXPECT_EQ(study.surround.code, 128);
    EXPECT_EQ(study.plan.sessions, 3);
    EXPECT_EQ(study.plan.break_every, 50);
    EXPECT_EQ(study.instructions.file, "instructions.md");
    ASSERT_EQ(study.scenes.size(), 1u);
    EXPECT_EQ(study.scenes[0].label, "bunny");
    EXPECT_EQ(study.scenes[0].diameter_mm, 100);
    EXPECT_TRUE(study.variants.empty());
    ASSERT_EQ(study.conditions.size(), 2u);
    const auto& glow = std::get<Rendering>(study.conditions[0].source);
    EXPECT_EQ(glow.method, "shss");
    EXPECT_EQ(glow.dials, (Dials{{"bands", std::int64_t{5}}}));
}

TEST(StudyFile, RemembersTheLinesOfItsTables) {
    const auto study = parsed(minimal);
    EXPECT_EQ(study.scenes[0].line, 9);
    EXPECT_EQ(study.conditions[0].line, 14);
    EXPECT_EQ(study.conditions[1].line, 18);
}

TEST(StudyFile, OfTheManualIsReadInFull) {
    const auto study = parsed(example());
    EXPECT_EQ(study.id, "skin-pilot");
    EXPECT_EQ(study.plan.sessions, 2);
    EXPECT_EQ(study.scenes.at(0).turn_degrees, 20);
    EXPECT_EQ(study.scenes.at(0).elevation_degrees, 10);
    EXPECT_EQ(study.scenes.at(0).material, "skin1");
    EXPECT_EQ(study.scenes.at(1).material, "jade");
    EXPECT_EQ(study.scenes.at(1).mm_per_unit, 25);
    EXPECT_EQ(study.variants.at(0).label, "lit from behind");
    EXPECT_TRUE(std::holds_alternative<OwnImages>(study.conditions.at(3).source));
}

TEST(StudyFile, HasDirectionsOfUnitLength) {
    const auto study = parsed(example());
    const auto& back = study.variants.at(0).lights.at(0).to_light;
    EXPECT_NEAR(std::hypot(back[0], back[1], back[2]), 1, 1e-15);
    EXPECT_NEAR(back[1] / back[2], -0.3, 1e-15);
    EXPECT_LT(back[2], 0); // behind the model
    EXPECT_EQ(study.variants.at(1).lights.at(0).to_light, (std::array<double, 3>{-1, 0, 0}));
}

TEST(ShippedStudies, AreAllRead) {
    int read = 0;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(PAIRLIGHT_SOURCE_DIR) / "protocols/studies"))
        if (entry.path().extension() == ".toml") {
            const auto name = entry.path().stem().string();
            EXPECT_EQ(parsed(contents("protocols/studies/" + name + ".toml")).id, name);
            ++read;
        }
    EXPECT_EQ(read, 3);
}

TEST(ShippedStudies, HaveInstructionsThatAskTheirQuestion) {
    const auto instructions = contents("protocols/studies/instructions.md");
    for (const auto* name : {"quick", "shss-2012", "own-images"}) {
        const auto study = parsed(contents(fmt::format("protocols/studies/{}.toml", name)));
        EXPECT_EQ(study.instructions.file, "instructions.md");
        EXPECT_THAT(instructions, testing::HasSubstr(study.question));
    }
    EXPECT_THAT(instructions, testing::HasSubstr("\n---\n"));
}

TEST(StudyFile, OfOwnImagesNeedsNoModelMaterialOrLight) {
    const auto study = parsed(R"([study]
id = "own"
title = "Own"
question = "Which?"
seed = 0
width = 100
height = 100
[[scene]]
id = "garden"
[[variant]]
id = "noon"
[[condition]]
id = "a"
source = "images"
[[condition]]
id = "b"
source = "images"
)");
    EXPECT_EQ(study.scenes.at(0).model, "");
    EXPECT_EQ(study.variants.at(0).id.value, "noon");
}

TEST(StudyFile, GivesASceneItsSizeInOneWay) {
    const auto scene = [](const std::string& keys) {
        return changed("model = \"bunny\"", "model = \"bunny\"\n" + keys);
    };
    EXPECT_EQ(parsed(scene("mm_per_unit = 1000")).scenes.at(0).mm_per_unit, 1000);
    EXPECT_FALSE(parsed(scene("diameter_mm = 80")).scenes.at(0).mm_per_unit);
    EXPECT_FALSE(parsed(minimal).scenes.at(0).mm_per_unit); // 100 mm across
    EXPECT_EQ(complaint(scene("diameter_mm = 80\nmm_per_unit = 1000")),
              "13: a scene with both 'diameter_mm' and 'mm_per_unit', expected one: either gives "
              "the model's size");
    for (const std::string bad : {"0", "-1", "nan", "inf", "1e10", "\"m\""})
        EXPECT_THAT(complaint(scene("mm_per_unit = " + bad)),
                    testing::StartsWith("12: mm_per_unit in [[scene]] is "))
            << bad;
}

TEST(StudyFile, MayGiveAConditionCoefficientsOfItsOwn) {
    const std::string k = "[condition.k.bunny]\nambient = [0, 0, 0]\ndiffuse = [0.1, 0.2, 0.3]\n"
                          "specular = [0, 0, 0]\nscatter = [1, 1, 1]\n";
    const auto study = parsed(minimal + k);
    EXPECT_EQ(std::get<Rendering>(study.conditions.at(1).source).k,
              (std::map<std::string, ShadingCoefficients>{
                  {"bunny", {{0, 0, 0}, {0.1, 0.2, 0.3}, {0, 0, 0}, {1, 1, 1}}}}));
    EXPECT_EQ(complaint(minimal + "[condition.k.bunny]\nambient = [0, 0, 0]\n"),
              "21: [condition.k.bunny] has no 'diffuse', expected three numbers");
    auto of_a_horse = k;
    of_a_horse.replace(of_a_horse.find("bunny"), 5, "horse");
    EXPECT_EQ(complaint(minimal + of_a_horse),
              "18: condition 'plain' has coefficients for 'horse', expected the id of a scene");
    EXPECT_THAT(complaint(minimal + k + "gloss = 3\n"), testing::HasSubstr("unknown key 'gloss'"));
    EXPECT_THAT(complaint(minimal + "[condition.k.bunny]\ndiffuse = [-1, 0, 0]\n"),
                testing::HasSubstr("expected three numbers"));
}

TEST(StudyFile, SaysOfAReconstructionThatItIsOne) {
    const auto label = [](const std::string& lines) {
        return parsed(changed("method = \"phong\"", "method = \"guess\"\n" + lines))
            .conditions.at(1)
            .label;
    };
    EXPECT_EQ(label(""), "plain (reconstruction)");
    EXPECT_EQ(label("label = \"Somebody, a reconstruction\""), "Somebody, a reconstruction");
    EXPECT_EQ(
        complaint(changed("method = \"phong\"", "method = \"guess\"\nlabel = \"Somebody 2007\"")),
        "21: label in [[condition]] is \"Somebody 2007\", expected the word "
        "\"reconstruction\" in it, for that is what method 'guess' is");
}

TEST(StudyFile, KeepsNumbersAndNamesOfDialsApart) {
    const auto dial = [](const std::string& text) {
        const auto study =
            parsed(changed("method = \"shss\"", "method = \"shss\"\nbands = " + text));
        return std::get<Rendering>(study.conditions.at(0).source).dials.at("bands");
    };
    EXPECT_EQ(dial("3"), DialValue(std::int64_t{3}));
    EXPECT_EQ(dial("3.0"), DialValue(3.0));
    EXPECT_EQ(dial("\"auto\""), DialValue(std::string("auto")));
}

TEST(StudyFile, MayHaveSeveralLightsFarAndNear) {
    const auto study = parsed(minimal + R"([[variant]]
id = "two"
[[variant.light]]
to_light = [0, 0, -2]
intensity = [1, 0.5, 0.25]
[[variant.light]]
position_mm = [0, 200, 0]
reference_mm = 150
)");
    const auto& lights = study.variants.at(0).lights;
    ASSERT_EQ(lights.size(), 2u);
    EXPECT_EQ(lights[0], (Light{.to_light = {0, 0, -1}, .intensity = {1, 0.5, 0.25}}));
    EXPECT_EQ(lights[1],
              (Light{.kind = Light::Kind::Near, .position_mm = {0, 200, 0}, .reference_mm = 150}));
}

TEST(StudyFile, HasItsSurroundAsACodeValue) {
    EXPECT_EQ(parsed(minimal + "[display]\nsurround = \"code:0\"\n").surround.code, 0);
    EXPECT_EQ(parsed(minimal + "[display]\nsurround = \"code:255\"\n").surround.code, 255);
    for (const std::string surround : {"code:256", "code:", "code:-1", "code:12x", "128",
                                       "code:99999999999999999999", "lstar:101"})
        EXPECT_THAT(complaint(minimal + "[display]\nsurround = \"" + surround + "\"\n"),
                    testing::StartsWith("22: surround in [display] is \"" + surround +
                                        "\", expected \"code:0\" to \"code:255\", the grey's 8-bit "
                                        "code value, or"));
}

TEST(StudyFile, KeepsItsInstructionsInItsFolder) {
    for (const std::string file : {"/etc/passwd", "../other.md", "a/../../b.md"})
        EXPECT_EQ(complaint(minimal + "[instructions]\nfile = \"" + file + "\"\n"),
                  "22: file in [instructions] is \"" + file +
                      "\", expected a file inside the study folder");
}

} // namespace
