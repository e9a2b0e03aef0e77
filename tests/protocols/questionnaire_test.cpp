#include "protocols/questionnaire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace protocols;
using testing::HasSubstr;

const ObserverQuestion& question(const std::vector<ObserverQuestion>& all, const std::string& id) {
    for (const auto& each : all)
        if (each.id == id)
            return each;
    throw std::out_of_range(id);
}

std::map<std::string, std::string> passing_answers() {
    return {{"age", "30-34"}, {"sex", "not stated"},      {"glasses", "no"},
            {"acuity", "1"},  {"ishihara_errors", "0"},   {"ishihara_medium", "print"},
            {"expert", "no"}, {"worked_on_methods", "no"}};
}

TEST(Screening, PassesNormalVision) {
    EXPECT_EQ(screening(standard_questions(), passing_answers()), "passed");
}

TEST(Screening, NamesWhatFailed) {
    auto answers = passing_answers();
    answers["acuity"] = "0.66";
    answers["worked_on_methods"] = "yes";
    EXPECT_EQ(screening(standard_questions(), answers), "failed: acuity, worked_on_methods");
}

TEST(Screening, HasItsLimitsWhereTheyAreSaidToBe) {
    const auto all = standard_questions();
    EXPECT_TRUE(passes(question(all, "acuity"), "0.67"));
    EXPECT_FALSE(passes(question(all, "acuity"), "0.669"));
    EXPECT_TRUE(passes(question(all, "ishihara_errors"), "2"));
    EXPECT_FALSE(passes(question(all, "ishihara_errors"), "3"));
}

TEST(Answers, AreTakenInOneSpellingOnly) {
    const auto all = standard_questions();
    EXPECT_EQ(*checked_answer(question(all, "acuity"), "0.80"), "0.8");
    EXPECT_THAT(checked_answer(question(all, "acuity"), "nan").error(),
                HasSubstr("expected a number from 0.05 to 3"));
    EXPECT_THAT(checked_answer(question(all, "acuity"), "20/20").error(), HasSubstr("\"20/20\""));
    EXPECT_THAT(checked_answer(question(all, "sex"), "f").error(),
                HasSubstr("expected one of female, male, other, not stated"));
}

} // namespace
