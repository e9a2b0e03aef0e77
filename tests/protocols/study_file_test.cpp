#include "protocols/study.h"

#include <fmt/format.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace {

using namespace protocols;

/// Dials by name alone, and one that is checked: what they mean is not this room's business.
tl::expected<Dials, DialProblem> complete(const std::string& method, const Dials& given) {
    const std::map<std::string, std::set<std::string>> dials_of{
        {"phong", {}},
        {"green", {"law", "depth_map"}},
        {"shss", {"bands", "law", "thickness", "directions"}},
        {"guess", {}}};
    for (const auto& [name, value] : given)
        if (!dials_of.at(method).contains(name))
            return tl::unexpected(DialProblem{name, "is no dial of " + method});
    auto dials = given;
    if (method == "shss" &&
        dials.try_emplace("bands", std::int64_t{5}).first->second == DialValue(std::int64_t{9}))
        return tl::unexpected(DialProblem{"bands", "is 9, expected less"});
    return dials;
}

KnownNames known_names() {
    return {.methods = {"phong", "green", "shss", "guess"},
            .materials = {"apple", "chicken1", "chicken2", "cream", "ketchup", "marble", "potato",
                          "skim-milk", "skin1", "skin2", "spectralon", "whole-milk"},
            .caveats = {{"guess", "reconstruction"}},
            .complete = complete};
}

std::string contents(const std::string& path_from_root) {
    std::ifstream file(std::string(PAIRLIGHT_SOURCE_DIR) + "/" + path_from_root);
    EXPECT_TRUE(file.is_open()) << path_from_root;
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

Study parsed(const std::string& text) {
    const auto study = parse_study(text, "study.toml", known_names());
    EXPECT_TRUE(study.has_value()) << (study ? "" : study.error());
    return study.value_or(Study{});
}

/// The first complaint about a text, without the file's name: "line: what".
std::string complaint(const std::string& text) {
    const auto study = parse_study(text, "study.toml", known_names());
    EXPECT_FALSE(study.has_value());
    const auto message = study ? "study.toml:it was read" : study.error();
    EXPECT_TRUE(message.starts_with("study.toml:")) << message;
    return message.substr(std::string_view("study.toml:").size());
}

/// The smallest rendered study, whose lines the complaints below refer to.
const std::string minimal = R"([study]
id = "pilot"
title = "A pilot"
question = "Which?"
seed = 7
width = 320
height = 240

[[scene]]
id = "bunny"
model = "bunny"
material = "marble"

[[condition]]
id = "glow"
method = "shss"

[[condition]]
id = "plain"
method = "phong"
)";

std::string changed(const std::string& line, const std::string& replacement) {
    auto text = minimal;
    const auto place = text.find(line);
    EXPECT_NE(place, std::string::npos) << line;
    return text.replace(place, line.size(), replacement);
}

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

/// The example of the manual: the text between ```toml and ```.
std::string example() {
    const auto page = contents("docs/study-file.md");
    const auto begin = page.find("```toml\n") + 8;
    return page.substr(begin, page.find("```", begin) - begin);
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

TEST(StudyFile, ThatIsNotTomlIsRefusedWithItsLine) {
    EXPECT_THAT(complaint(changed("seed = 7", "seed = = 7")), testing::StartsWith("5: not TOML: "));
    EXPECT_THAT(complaint(minimal + "[[condition]\n"), testing::StartsWith("21: not TOML: "));
    EXPECT_THAT(complaint(changed("seed = 7", "seed = 7\nseed = 8")),
                testing::StartsWith("6: not TOML: "));
    EXPECT_THAT(complaint("\xff\xfe"), testing::StartsWith("1: not TOML: "));
}

TEST(StudyFile, ThatIsEmptyMissesItsStudy) {
    EXPECT_EQ(complaint(""), "1: the study file has no 'study', expected the table [study]");
}

TEST(StudyFile, WithAnUnknownKeyIsToldWhichOneWasProbablyMeant) {
    EXPECT_EQ(complaint(changed("width =", "widht =")),
              "6: unknown key 'widht' in [study], did you mean 'width'?");
    EXPECT_EQ(complaint(changed("height = 240", "height = 240\nhieght = 3")),
              "8: unknown key 'hieght' in [study], expected one of id, title, question, seed, "
              "width, height (did you mean 'height'?)");
    EXPECT_THAT(complaint(minimal + "[sesion]\n"),
                testing::AllOf(testing::StartsWith("21: unknown key 'sesion' in the study file"),
                               testing::HasSubstr("did you mean 'session'?")));
    EXPECT_EQ(complaint("# A pilot\n" + changed("[study]", "[studdy]")),
              "2: unknown key 'studdy' in the study file, did you mean 'study'?");
    EXPECT_THAT(complaint(changed("model = \"bunny\"", "model = \"bunny\"\ncolour = 3")),
                testing::StartsWith("12: unknown key 'colour' in [[scene]]"));
}

TEST(StudyFile, WithAMissingKeyIsToldTheTableThatLacksIt) {
    EXPECT_EQ(complaint(changed("seed = 7\n", "")),
              "1: [study] has no 'seed', expected a whole number of 0 or more");
    EXPECT_EQ(complaint(changed("model = \"bunny\"\n", "")),
              "9: [[scene]] has no 'model', expected text in quotes, on one line");
    EXPECT_THAT(complaint(changed("material = \"marble\"\n", "")),
                testing::StartsWith("9: [[scene]] has no 'material', expected one of apple, "));
    EXPECT_THAT(complaint(changed("method = \"phong\"", "")),
                testing::HasSubstr("[[condition]] 'plain' has no 'method', expected one of phong, "
                                   "green, shss, guess, or source = \"images\""));
    EXPECT_EQ(complaint(minimal + "[[variant]]\nid = \"back\"\n"),
              "21: [[variant]] has no 'to_light', expected three numbers [x, y, z], not all zero");
}

TEST(StudyFile, WithAValueOfTheWrongTypeIsToldTheRightOne) {
    EXPECT_EQ(complaint(changed("width = 320", "width = \"320\"")),
              "6: width in [study] is \"320\", expected a whole number from 16 to 16384");
    EXPECT_EQ(complaint(changed("width = 320", "width = 320.5")),
              "6: width in [study] is 320.5, expected a whole number from 16 to 16384");
    EXPECT_EQ(complaint(changed("title = \"A pilot\"", "title = 2026-01-01")),
              "3: title in [study] is a date or time, expected text in quotes, on one line");
    EXPECT_EQ(complaint(changed("title = \"A pilot\"", "title = \"A\\npilot\"")).substr(0, 8),
              "3: title");
    EXPECT_EQ(complaint(changed("method = \"shss\"", "method = true")),
              "16: method in [[condition]] is true, expected one of phong, green, shss, guess");
    EXPECT_EQ(complaint("study = 3\n" + minimal.substr(minimal.find("[[scene]]"))),
              "1: study in the study file is 3, expected the table [study]");
    EXPECT_THAT(complaint(changed("[[scene]]", "[scene]")),
                testing::HasSubstr("scene in the study file is a table, expected [[scene]] in "
                                   "double brackets above each"));
}

TEST(StudyFile, WithAValueOutOfRangeIsToldTheRange) {
    EXPECT_EQ(complaint(changed("seed = 7", "seed = -7")),
              "5: seed in [study] is -7, expected a whole number of 0 or more");
    EXPECT_EQ(complaint(minimal + "[session]\nsessions = 0\n"),
              "22: sessions in [session] is 0, expected a whole number from 1 to 100");
    EXPECT_EQ(complaint(minimal + "[session]\nsessions = 9223372036854775807\n").substr(0, 12),
              "22: sessions");
    const auto scene = [](const std::string& key) {
        return complaint(changed("model = \"bunny\"", "model = \"bunny\"\n" + key));
    };
    EXPECT_EQ(scene("diameter_mm = nan"),
              "12: diameter_mm in [[scene]] is nan, expected a number from 0.001 to 1000000");
    EXPECT_THAT(scene("diameter_mm = -2"), testing::HasSubstr("is -2, expected"));
    EXPECT_THAT(scene("turn_degrees = inf"), testing::HasSubstr("expected a number from -360"));
    EXPECT_THAT(scene("elevation_degrees = \"high\""), testing::HasSubstr("is \"high\", expected"));
}

/// `minimal`, whose scene is made of the material these lines define from line 21 on.
std::string with_material(const std::string& lines) {
    return changed("\"marble\"", "\"jade\"") + "[[material]]\nid = \"jade\"\n" + lines;
}

TEST(StudyFile, HasMaterialsOfItsOwn) {
    const auto study = parsed(example());
    const auto* jade = own_material(study, "jade");
    ASSERT_NE(jade, nullptr);
    const auto& medium = std::get<Coefficients>(jade->medium);
    EXPECT_EQ(medium.sigma_a, (std::array<double, 3>{0.006, 0.003, 0.005}));
    EXPECT_EQ(medium.sigma_s_reduced, (std::array<double, 3>{0.8, 1.0, 0.9}));
    EXPECT_EQ(medium.index, 1.6);
    const auto* wax = own_material(study, "wax");
    ASSERT_NE(wax, nullptr);
    const auto& colour = std::get<Colour>(wax->medium);
    EXPECT_EQ(colour.reflectance, (std::array<double, 3>{0.85, 0.7, 0.45}));
    EXPECT_EQ(colour.mean_free_path_mm, (std::array<double, 3>{4, 2, 1}));
    EXPECT_EQ(own_material(study, "skin1"), nullptr); // measured
}

TEST(StudyFile, ReducesTheScatteringOfAMaterialByItsAnisotropy) {
    const auto study = parsed(with_material("sigma_a = 0.01\nsigma_s = [10, 8, 6]\ng = 0.75\n"));
    const auto& medium = std::get<Coefficients>(study.materials.at(0).medium);
    EXPECT_EQ(medium.sigma_s_reduced, (std::array<double, 3>{2.5, 2, 1.5}));
    EXPECT_EQ(medium.sigma_a, (std::array<double, 3>{0.01, 0.01, 0.01})); // one number for all
    EXPECT_EQ(medium.index, 1.3);
}

TEST(StudyFile, WithAMaterialThatIsHalfDefinedIsToldTheOtherHalf) {
    EXPECT_EQ(complaint(with_material("")),
              "22: [[material]] 'jade' has neither 'sigma_a' nor 'colour', expected its "
              "coefficients or its colour");
    EXPECT_EQ(complaint(with_material("sigma_a = 1\n")),
              "21: [[material]] has no 'sigma_s_reduced', expected three numbers [r, g, b] or one "
              "for all, each from 0 to 1000000");
    EXPECT_EQ(complaint(with_material("sigma_a = 1\nsigma_s = 2\n")),
              "24: 'sigma_s' without 'g', expected the mean cosine of scattering beside it, or "
              "'sigma_s_reduced', which is (1 - g) sigma_s");
    EXPECT_EQ(complaint(with_material("sigma_a = 1\nsigma_s_reduced = 2\ng = 0.5\n")),
              "25: 'g' without 'sigma_s', expected both, or 'sigma_s_reduced' alone, which is "
              "(1 - g) sigma_s");
    EXPECT_THAT(complaint(with_material("colour = 0.5\n")),
                testing::StartsWith("21: [[material]] has no 'mean_free_path_mm', expected"));
}

TEST(StudyFile, WithAMaterialDefinedTwiceOverIsRefused) {
    EXPECT_EQ(complaint(with_material("sigma_a = 1\nsigma_s = 2\ng = 0.5\nsigma_s_reduced = 1\n")),
              "26: a material with both 'sigma_s' and 'sigma_s_reduced', expected one");
    EXPECT_EQ(complaint(with_material("colour = 0.5\nmean_free_path_mm = 1\nindex = 1.4\n")),
              "25: a material with both 'colour' and 'index', expected one: coefficients follow "
              "from the colour");
    EXPECT_EQ(complaint(with_material("sigma_a = 1\nsigma_s_reduced = 1\nmean_free_path_mm = 1\n")),
              "25: 'mean_free_path_mm' without 'colour', expected it only there: coefficients say "
              "how far light spreads");
    const std::string jade = "colour = 0.5\nmean_free_path_mm = 1\n";
    EXPECT_EQ(complaint(with_material(jade + "[[material]]\nid = \"jade\"\n" + jade)),
              "25: id 'jade' is already that of the material at line 21, expected a name of its "
              "own");
    EXPECT_EQ(complaint(minimal + "[[material]]\nid = \"marble\"\n" + jade),
              "22: id in [[material]] is \"marble\", expected another name: a measured material "
              "is called that");
}

TEST(StudyFile, WithAnImpossibleMediumIsToldTheRange) {
    const std::string range = "expected three numbers [r, g, b] or one for all, each from ";
    EXPECT_EQ(complaint(with_material("sigma_a = [1, -1, 1]\nsigma_s_reduced = 1\n")),
              "23: sigma_a in [[material]] is [1, -1, 1], " + range + "0 to 1000000");
    for (const std::string bad : {"[1, 1]", "[1, 1, nan]", "nan", "\"red\"", "true", "inf"})
        EXPECT_THAT(complaint(with_material("sigma_a = 1\nsigma_s_reduced = " + bad + "\n")),
                    testing::AllOf(testing::StartsWith("24: sigma_s_reduced in [[material]] is "),
                                   testing::HasSubstr(range)))
            << bad;
    EXPECT_EQ(complaint(with_material("colour = [0.5, 1.1, 0.5]\nmean_free_path_mm = 1\n")),
              "23: colour in [[material]] is [0.5, 1.1, 0.5], " + range + "0 to 1");
    EXPECT_THAT(complaint(with_material("colour = 0.5\nmean_free_path_mm = 0\n")),
                testing::StartsWith("24: mean_free_path_mm in [[material]] is 0, expected"));
    EXPECT_THAT(
        complaint(with_material("sigma_a = 1\nsigma_s = 1\ng = 1\n")),
        testing::StartsWith("25: g in [[material]] is 1, expected a number from -0.999 to"));
    EXPECT_THAT(
        complaint(with_material("sigma_a = 1\nsigma_s_reduced = 1\nindex = 0.9\n")),
        testing::StartsWith("25: index in [[material]] is 0.9, expected a number from 1 to"));
    EXPECT_EQ(complaint(with_material("sigma_a = [0, 1, 1]\nsigma_s_reduced = [0, 1, 1]\n")),
              "23: neither absorption nor scattering in a colour channel, expected a medium that "
              "light meets");
}

TEST(StudyFile, WithTheNameOfItsOwnMaterialMisspeltIsToldIt) {
    EXPECT_THAT(complaint(changed("\"marble\"", "\"jabe\"") +
                          "[[material]]\nid = \"jade\"\ncolour = 0.5\nmean_free_path_mm = 1\n"),
                testing::HasSubstr("whole-milk, jade (did you mean 'jade'?)"));
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

TEST(StudyFile, WithADirectionThatIsNoneIsRefused) {
    for (const std::string direction :
         {"[0, 0, 0]", "[1, 2]", "[1, 2, 3, 4]", "[nan, 0, 1]", "[inf, 0, 1]", "[\"x\", 0, 1]"})
        EXPECT_EQ(complaint(minimal + "[[variant]]\nid = \"back\"\nto_light = " + direction + "\n"),
                  "23: to_light in [[variant]] is " + direction +
                      ", expected three numbers [x, y, z], not all zero")
            << direction;
    EXPECT_THAT(complaint(changed("model = \"bunny\"", "model = \"bunny\"\nup = \"z\"")),
                testing::StartsWith("12: up in [[scene]] is \"z\", expected three numbers"));
}

TEST(StudyFile, WithANameTwiceIsToldWhereTheOtherIs) {
    EXPECT_EQ(complaint(changed("id = \"plain\"", "id = \"glow\"")),
              "18: id 'glow' is already that of the condition at line 14, expected a name of its "
              "own");
    EXPECT_THAT(complaint(minimal + "[[scene]]\nid=\"bunny\"\nmodel=\"b\"\nmaterial=\"cream\"\n"),
                testing::HasSubstr("already that of the scene at line 9"));
    const std::string back = "[[variant]]\nid = \"back\"\nto_light = [0, 0, -1]\n";
    EXPECT_THAT(complaint(minimal + back + back),
                testing::HasSubstr("already that of the variant at line 21"));
}

TEST(StudyFile, WithAnIdThatNoFileCanHaveIsRefused) {
    for (const std::string id :
         {"a/b", "..", ".hidden", "-rf", "Glow", "two words", "gl\u00f6w", "a\\\\b", "a,b"})
        EXPECT_THAT(complaint(changed("id = \"glow\"", "id = \"" + id + "\"")),
                    testing::AllOf(testing::StartsWith("15: id in [[condition]] is "),
                                   testing::HasSubstr("a-z 0-9 . _ -")))
            << id;
    EXPECT_THAT(complaint(changed("\"pilot\"", "\"" + std::string(65, 'a') + "\"")),
                testing::HasSubstr("at most 64"));
    EXPECT_THAT(complaint(changed("id = \"glow\"", "id = \"\"")), testing::StartsWith("15: id"));
}

TEST(StudyFile, WithAnUnknownNameIsToldTheKnownOnes) {
    EXPECT_EQ(complaint(changed("method = \"shss\"", "method = \"shs\"")),
              "16: method in [[condition]] is \"shs\", expected one of phong, green, shss, guess "
              "(did you "
              "mean 'shss'?)");
    EXPECT_THAT(complaint(changed("\"marble\"", "\"marbel\"")),
                testing::HasSubstr("(did you mean 'marble'?)"));
    EXPECT_THAT(complaint(changed("method = \"phong\"", "source = \"film\"")),
                testing::HasSubstr("source in [[condition]] is \"film\", expected one of images"));
}

TEST(StudyFile, WithADialItsMethodCannotTakeIsRefused) {
    const auto with = [](const std::string& dial) {
        return complaint(changed("method = \"shss\"", "method = \"shss\"\n" + dial));
    };
    EXPECT_EQ(with("bands = 9"), "17: bands in [[condition]] is 9, expected less");
    EXPECT_EQ(with("colour = \"red\""), "17: colour in [[condition]] is no dial of shss");
    EXPECT_EQ(with("bands = [1, 2]"),
              "17: bands in [[condition]] is [1, 2], expected a number, or text in quotes");
    EXPECT_THAT(with("bands = [1, 2, [], 4, 5]"),
                testing::StartsWith("17: bands in [[condition]] is [1, 2, [], 4, ...], expected"));
    EXPECT_EQ(complaint(changed("method = \"phong\"", "method = \"phong\"\nbands = 3")),
              "21: bands in [[condition]] is no dial of phong");
    EXPECT_EQ(complaint(changed("method = \"phong\"", "source = \"images\"\nlaw = \"paper\"")),
              "21: law in [[condition]] is no dial of source \"images\", which has none");
    EXPECT_THAT(complaint(changed("method = \"phong\"", "method = \"phong\"\nsource = \"images\"")),
                testing::HasSubstr("both 'method' and 'source'"));
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

TEST(StudyFile, WithALightThatIsNoneIsRefused) {
    const auto with = [](const std::string& lines) {
        return complaint(minimal + "[[variant]]\nid = \"two\"\n" + lines);
    };
    EXPECT_THAT(with("to_light = [0, 0, 1]\n[[variant.light]]\nto_light = [0, 0, 1]\n"),
                testing::HasSubstr("both 'to_light' and [[variant.light]]"));
    EXPECT_THAT(with("[[variant.light]]\nto_light = [0, 0, 1]\nposition_mm = [0, 0, 1]\n"),
                testing::HasSubstr("both 'to_light' and 'position_mm'"));
    EXPECT_THAT(with("[[variant.light]]\nintensity = [1, 1, 1]\n"),
                testing::HasSubstr("has no 'to_light'"));
    EXPECT_THAT(with("[[variant.light]]\nto_light = [0, 0, 1]\nintensity = [1, -1, 1]\n"),
                testing::HasSubstr("is [1, -1, 1], expected three numbers"));
    EXPECT_EQ(with("light = []\n"), "23: 0 lights in [[variant]], expected 1 to 8");
}

TEST(StudyFile, WithNothingToCompareIsRefused) {
    const auto one = minimal.substr(0, minimal.rfind("[[condition]]"));
    EXPECT_EQ(complaint(one), "14: 1 [[condition]] in this study, expected at least 2 to compare");
    const auto none = minimal.substr(0, minimal.find("[[condition]]"));
    EXPECT_EQ(complaint(none), "1: 0 [[condition]] in this study, expected at least 2 to compare");
    EXPECT_EQ(complaint(changed("[[scene]]\nid = \"bunny\"\nmodel = \"bunny\"\nmaterial = "
                                "\"marble\"\n",
                                "")),
              "1: 0 [[scene]] in this study, expected at least 1 to show");
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

TEST(StudyFile, IsToldItsFirstOffenceOnly) {
    auto text = changed("seed = 7", "seed = \"x\"");
    text += "bands = 9\ncolour = 1\n";
    EXPECT_THAT(complaint(text), testing::StartsWith("5: seed"));
}

// Half a file is never half a study: every prefix is refused with a message, or is a study.
TEST(StudyFile, CutAnywhereIsRefusedOrWhole) {
    int refused = 0;
    for (std::size_t length = 0; length < minimal.size(); ++length) {
        const auto study = parse_study(minimal.substr(0, length), "cut.toml", known_names());
        if (study) {
            EXPECT_EQ(study->conditions.size(), 2u) << length;
        } else {
            EXPECT_THAT(study.error(), testing::StartsWith("cut.toml:"));
            ++refused;
        }
    }
    EXPECT_GT(refused, 200);
}

RC_GTEST_PROP(StudyFile, SurvivesAnyByteInAnyPlace, (unsigned char byte)) {
    auto text = minimal;
    text[*rc::gen::inRange<std::size_t>(0, minimal.size())] = static_cast<char>(byte);
    const auto study = parse_study(text, "study.toml", known_names());
    RC_ASSERT(study.has_value() || study.error().starts_with("study.toml:"));
}

} // namespace
