#include "experiment/report/plain_words.h"
#include "tests/experiment/report/shared_experiment.h"

#include <cmath>

namespace {

using namespace experiment::report;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string result(const ReportContents& contents) {
    std::string text;
    for (const auto& paragraph : result_in_words(contents))
        text += paragraph + "\n";
    return text;
}

TEST(PlainWords, ListAsPeopleDo) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({"a"}), "a");
    EXPECT_EQ(listed({"a", "b"}), "a and b");
    EXPECT_EQ(listed({"a", "b", "c"}), "a, b and c");
}

// The figures are those of the shared experiment's expected.json.
TEST(PlainWords, NameTestLevelAndUnits) {
    const auto text = result(shared_experiment());
    EXPECT_THAT(
        text,
        StartsWith("SHSS (2.17, 72\u00a0%) was chosen most often, before PRT (2.00, 67\u00a0%), "
                   "Patro (1.24, 41\u00a0%) and Green (0.59, 20\u00a0%)."));
    EXPECT_THAT(
        text,
        HasSubstr(
            "repeated-measures analysis of variance of the 10 observers' mean "
            "votes, F(3, 27) = 59.34, p\u00a0=\u00a05.2\u00a0\u00d7\u00a010\u207b\u00b9\u00b2"));
    EXPECT_THAT(
        text,
        HasSubstr("p\u00a0=\u00a01.9\u00a0\u00d7\u00a010\u207b\u2078 with Greenhouse and Geisser"));
    EXPECT_THAT(text, HasSubstr("at the 5\u00a0% level"));
    EXPECT_THAT(text, HasSubstr("The units are observers"));
    EXPECT_THAT(text,
                HasSubstr("Tukey's test at the 5\u00a0% level for all 6 pairs together (27 error "
                          "degrees of freedom), all pairs differ except SHSS and PRT."));
}

TEST(PlainWords, DoNotTakeNoDifferenceForEquality) {
    auto contents = shared_experiment();
    auto& effect = contents.findings.within.front().analysis.effects.front();
    effect.test.p = 0.2;
    effect.sphericity.p_greenhouse_geisser = 0.25;
    for (auto& pair : contents.findings.within_tukey.pairs)
        pair.significant = false;
    const auto text = result(contents);
    EXPECT_THAT(text, HasSubstr("A difference between the conditions was not found"));
    EXPECT_THAT(text, HasSubstr("That does not show them to be equal"));
    EXPECT_THAT(text, HasSubstr("no two conditions differ"));
    EXPECT_THAT(text, Not(HasSubstr("differ by more")));
}

TEST(PlainWords, AreDecidedByTheCorrectedP) {
    auto contents = shared_experiment();
    auto& effect = contents.findings.within.front().analysis.effects.front();
    effect.test.p = 0.04;
    effect.sphericity.greenhouse_geisser = 0.6;
    effect.sphericity.p_greenhouse_geisser = 0.06;
    EXPECT_THAT(result(contents), HasSubstr("A difference between the conditions was not found"));
}

TEST(PlainWords, SayWhyThereIsNoTest) {
    auto contents = shared_experiment();
    contents.findings.within.clear();
    contents.findings.within_tukey.pairs.clear();
    contents.findings.why_no_anova = "one observer is not enough";
    EXPECT_THAT(result(contents),
                HasSubstr("No analysis of variance: one observer is not enough."));
}

TEST(PlainWords, LetTiedLeadersShareTheLead) {
    auto contents = shared_experiment();
    contents.findings.ranking[0].rank = 1.5;
    contents.findings.ranking[1].rank = 1.5;
    EXPECT_THAT(
        result(contents),
        StartsWith("Chosen most often, and equally often, were SHSS (2.17, 72\u00a0%) and PRT"));
    for (auto& place : contents.findings.ranking)
        place.rank = 2.5;
    EXPECT_THAT(result(contents), StartsWith("All conditions were chosen equally often"));
}

} // namespace
