// What a study file that is wrong is told: where, what, and what would be right.
#include "tests/protocols/study_texts.h"

#include <rapidcheck/gtest.h>

namespace {

using namespace study_texts;

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
