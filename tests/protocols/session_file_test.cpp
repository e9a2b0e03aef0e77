#include "protocols/questions.h"
#include "protocols/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace protocols;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string head = R"([study]
id = "s"
title = "T"
question = "Q?"
seed = 1
width = 16
height = 16
[[scene]]
id = "a"
[[condition]]
id = "x"
source = "images"
[[condition]]
id = "y"
source = "images"
[[condition]]
id = "z"
source = "images"
)";

Expected<Study> parsed(const std::string& rest) {
    return parse_study(head + rest, "study.toml", {});
}

TEST(SessionTables, MayAllBeMissing) {
    const auto study = parsed("");
    ASSERT_TRUE(study) << study.error();
    EXPECT_EQ(study->plan.response, Response::ForcedChoice);
    EXPECT_EQ(study->plan.longest_minutes, 30);
    EXPECT_EQ(study->keys, standard_keys());
    EXPECT_EQ(study->surround.code, 128);
    EXPECT_FALSE(study->panel.consent);
    EXPECT_TRUE(study->panel.questions.empty());
    EXPECT_EQ(study->room.ambient_lux, std::nullopt);
}

TEST(SessionTables, SayHowPairsAreShownAndAnswered) {
    const auto study = parsed("[session]\nresponse = \"seven-grades\"\npresentation = "
                              "\"sequential\"\nview_ms = 10000\nreference = \"z\"\n");
    ASSERT_TRUE(study) << study.error();
    EXPECT_EQ(study->plan.response, Response::SevenGrades);
    EXPECT_EQ(study->plan.presentation, Presentation::Sequential);
    EXPECT_EQ(study->plan.reference, ConditionId{"z"});
    EXPECT_EQ(all_questions(*study).size(), 1u); // x and y; nothing is compared with the reference
}

TEST(SessionTables, SayWhatIsPractisedAndHowLongAnAnswerIsWaitedFor) {
    const auto study = parsed("[session]\neasy_pair = [\"x\", \"z\"]\nhard_pair = [\"y\", \"x\"]\n"
                              "deadline_s = 10\nafter_deadline = \"missing\"\n");
    ASSERT_TRUE(study) << study.error();
    EXPECT_EQ(study->plan.easy_pair, (ConditionPair{ConditionId{"x"}, ConditionId{"z"}}));
    EXPECT_EQ(study->plan.hard_pair, (ConditionPair{ConditionId{"y"}, ConditionId{"x"}}));
    EXPECT_EQ(study->plan.deadline_s, 10);
    EXPECT_EQ(study->plan.after_deadline, AfterDeadline::Missing);
    EXPECT_EQ(parsed("")->plan.deadline_s, 0);
    EXPECT_EQ(parsed("")->plan.after_deadline, AfterDeadline::Again);
}

TEST(SessionTables, RefuseToPractiseWhatIsNeverCompared) {
    for (const auto* pair : {"[\"x\"]", "[\"x\", \"x\"]", "[\"x\", \"y\", \"z\"]"})
        EXPECT_EQ(parsed(std::string("[session]\neasy_pair = ") + pair + "\n").error(),
                  std::string("study.toml:20: easy_pair in [session] is ") + pair +
                      ", expected the ids of two conditions, such as [\"first\", \"second\"]");
    EXPECT_EQ(parsed("[session]\nhard_pair = [\"x\", \"w\"]\n").error(),
              "study.toml:20: hard_pair in [session] is [\"x\", \"w\"], expected the ids of two "
              "[[condition]] that are compared: 'w' is none");
    EXPECT_EQ(parsed("[session]\nreference = \"z\"\neasy_pair = [\"x\", \"z\"]\n").error(),
              "study.toml:21: easy_pair in [session] is [\"x\", \"z\"], expected the ids of two "
              "[[condition]] that are compared: 'z' is the reference");
}

TEST(SessionTables, RefuseWhatIsPractisedWithoutPracticeOrIsEasyAndHardAtOnce) {
    EXPECT_EQ(parsed("[session]\nhard_pair = [\"x\", \"y\"]\ntraining = 0\n").error(),
              "study.toml:20: hard_pair in [session] is [\"x\", \"y\"], expected no such key, or "
              "training = 1 or more: with training = 0, nothing is practised");
    EXPECT_THAT(parsed("[session]\ntraining = 0\neasy_pair = [\"x\", \"y\"]\n").error(),
                HasSubstr("study.toml:21: easy_pair in [session] is [\"x\", \"y\"]"));
    for (const auto* same : {"[\"x\", \"y\"]", "[\"y\", \"x\"]"})
        EXPECT_EQ(
            parsed(std::string("[session]\neasy_pair = [\"x\", \"y\"]\nhard_pair = ") + same + "\n")
                .error(),
            std::string("study.toml:21: hard_pair in [session] is ") + same +
                ", expected another pair than easy_pair: the same two cannot differ both "
                "most and least");
    EXPECT_TRUE(parsed("[session]\ntraining = 1\neasy_pair = [\"x\", \"y\"]\n"));
    EXPECT_TRUE(parsed("[session]\ntraining = 0\n"));
}

TEST(SessionTables, RefuseWhatHappensAfterADeadlineThatIsNotThere) {
    EXPECT_EQ(parsed("[session]\nafter_deadline = \"missing\"\n").error(),
              "study.toml:20: after_deadline in [session] is \"missing\", expected a 'deadline_s' "
              "beside it, or neither: without one, an answer is waited for as long as it takes");
    EXPECT_TRUE(parsed("[session]\ndeadline_s = 0\nafter_deadline = \"again\"\n"));
}

TEST(SessionTables, RefuseADeadlineBeforeAnswersCount) {
    EXPECT_THAT(parsed("[session]\nclosed_ms = 5000\ndeadline_s = 5\n").error(),
                HasSubstr("over before an answer counts (closed_ms = 5000)"));
    EXPECT_TRUE(parsed("[session]\nclosed_ms = 5000\ndeadline_s = 6\n"));
}

TEST(Scenes, OfOwnImagesMayHaveSizesOfTheirOwn) {
    const std::string scene = "[[scene]]\nid = \"b\"\n";
    const auto study = parsed(scene + "width = 300\nheight = 100\n");
    ASSERT_TRUE(study) << study.error();
    const auto sizes = picture_sizes(*study);
    EXPECT_EQ(sizes.at({"a"}), (PictureSize{16, 16}));
    EXPECT_EQ(sizes.at({"b"}), (PictureSize{300, 100}));
    EXPECT_EQ(parsed(scene + "width = 300\n").error(),
              "study.toml:21: width in [[scene]] is 300, expected a 'height' beside it: both or "
              "neither");
    EXPECT_EQ(parsed(scene + "height = 100\n").error(),
              "study.toml:21: height in [[scene]] is 100, expected a 'width' beside it: both or "
              "neither");
}

TEST(SessionTables, RefuseAReferenceThatIsNothingOrLeavesNothing) {
    EXPECT_EQ(
        parsed("[session]\nreference = \"w\"\n").error(),
        "study.toml:20: reference in [session] is \"w\", expected the id of a [[condition]] of "
        "this study");
    EXPECT_THAT(parsed("[session]\npresentation = \"sequential\"\n").error(),
                HasSubstr("have no 'view_ms'"));
}

TEST(SessionTables, FindTheGreyByTheCurveOfTheDisplay) {
    EXPECT_EQ(parsed("[display]\nsurround = \"linear:0.5\"\n")->surround.code, 188);
    EXPECT_EQ(parsed("[display]\nsurround = \"linear:0.5\"\neotf = \"gamma:2.2\"\n")->surround.code,
              186);
    EXPECT_EQ(parsed("[display]\neotf = \"table:cal.csv\"\n")->display.eotf.file, "cal.csv");
    EXPECT_THAT(parsed("[display]\neotf = \"gamma:9\"\n").error(), HasSubstr("study.toml:20"));
    EXPECT_THAT(parsed("[display]\neotf = \"table:../x\"\n").error(), HasSubstr("\"table:FILE\""));
    EXPECT_THAT(parsed("[display]\nsurround = \"grey\"\n").error(), HasSubstr("code:0"));
}

TEST(SessionTables, GiveKeysOneMeaning) {
    EXPECT_THAT(
        parsed("[keys]\nleft = [\"A\", \"KP_1\"]\nmuch_worse = [\"1\"]\n")->keys.at(Action::Left),
        ElementsAre("A", "KP_1"));
    EXPECT_THAT(parsed("[keys]\nleft = [\"Space\"]\n").error(),
                HasSubstr("the key 'Space' means both 'left' and 'forward'"));
    EXPECT_THAT(parsed("[keys]\nleft = [\"Lefty\"]\n").error(), HasSubstr("did you mean 'Left'?"));
    EXPECT_THAT(parsed("[keys]\nleft = []\n").error(), HasSubstr("a list of texts"));
}

TEST(SessionTables, AskWhatTheStudyWantsToKnow) {
    const auto study = parsed("[observer]\nrequired = 20\n[[question]]\nid = \"hand\"\nask = "
                              "\"Writing hand\"\nchoices = [\"left\", \"right\"]\n[[question]]\nid "
                              "= \"hours\"\nask = \"Hours of sleep\"\nleast = 0\ngreatest = "
                              "24\npasses_from = 4\n");
    ASSERT_TRUE(study) << study.error();
    EXPECT_TRUE(study->panel.consent);
    EXPECT_EQ(study->panel.required, 20);
    ASSERT_EQ(study->panel.questions.size(), standard_questions().size() + 2);
    EXPECT_FALSE(passes(study->panel.questions.back(), "3"));
    EXPECT_THAT(parsed("[observer]\n[[question]]\nid = \"age\"\nask = \"Age\"\n").error(),
                HasSubstr("an id that no other question has"));
}

} // namespace
