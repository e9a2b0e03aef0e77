#include "protocols/questions.h"
#include "tests/protocols/designs.h"

#include <set>
#include <tuple>

namespace {

using namespace protocols;
using tests::design;

TEST(AllQuestions, AreFiftyFourInTheStudyOfThreeScenesThreeVariantsFourConditions) {
    EXPECT_EQ(all_questions(design(3, 3, 4)).size(), 54u);
}

TEST(AllQuestions, AskEveryPairOfConditionsAtEveryPictureOnce) {
    std::set<std::tuple<int, int, int, int>> seen;
    for (const auto& [scene, variant, first, second] : all_questions(design(2, 3, 5))) {
        EXPECT_LT(first, second);
        EXPECT_TRUE(seen.insert({scene, variant, first, second}).second);
    }
    EXPECT_EQ(seen.size(), 2u * 3 * 10);
}

TEST(AllQuestions, OfOneConditionAreNone) {
    EXPECT_TRUE(all_questions(design(3, 3, 1)).empty());
}

TEST(QuestionAsATrial, HasItsFirstConditionOnTheSideThatIsNamed) {
    const auto study = design(2, 2, 3);
    EXPECT_EQ(trial(study, {1, 0, 0, 2}, Side::Left), (Trial{{"s1"}, {"v0"}, {"c0"}, {"c2"}}));
    EXPECT_EQ(trial(study, {1, 0, 0, 2}, Side::Right), (Trial{{"s1"}, {"v0"}, {"c2"}, {"c0"}}));
}

TEST(QuestionAsATrial, HasTheNamelessVariantWhereTheStudyHasNone) {
    EXPECT_EQ(trial(design(1, 0, 2), {0, 0, 0, 1}, Side::Left).variant.value, "");
}

} // namespace
