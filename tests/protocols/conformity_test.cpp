#include "protocols/conformity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace protocols;
using testing::HasSubstr;

ConformityLine line(const Study& study, const std::string& asked, const PanelSoFar& panel = {}) {
    for (auto& each : bt500_conformity(study, panel))
        if (each.asked.find(asked) != std::string::npos)
            return each;
    throw std::out_of_range(asked);
}

Study laboratory() {
    Study study;
    study.scenes.resize(3);
    study.conditions.resize(4);
    for (int i = 0; i < 4; ++i)
        study.conditions[static_cast<std::size_t>(i)].id.value = std::to_string(i);
    study.panel.questions = standard_questions();
    study.room = {120, 0.01, 0.01, 0.15, 10, 20, "D65"};
    study.display.screen_width_mm = 600;
    study.display.distance_mm = 700;
    study.plan.easy_pair = {{{"0"}, {"3"}}};
    study.plan.hard_pair = {{{"0"}, {"1"}}};
    return study;
}

TEST(Conformity, IsMetByALaboratoryButForWhatNobodyCanKnow) {
    for (const auto& each : bt500_conformity(laboratory()))
        if (each.asked.find("PLUGE") != std::string::npos)
            EXPECT_EQ(each.verdict, Verdict::OnlyTheExperimenterKnows);
        else if (each.asked.find("training pictures") != std::string::npos)
            EXPECT_EQ(each.verdict, Verdict::NotMet); // practice is drawn from the session's own
        else
            EXPECT_EQ(each.verdict, Verdict::Met) << each.asked << ": " << each.because;
}

TEST(Conformity, LeavesTheRoomToTheExperimenterUntilItIsRecorded) {
    auto study = laboratory();
    study.room = {};
    EXPECT_EQ(line(study, "peak white of").verdict, Verdict::OnlyTheExperimenterKnows);
    study.room.peak_cd_m2 = 300;
    EXPECT_EQ(line(study, "peak white of").verdict, Verdict::NotMet);
    study.room.peak_cd_m2 = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(line(study, "peak white of").verdict, Verdict::NotMet);
}

TEST(Conformity, CallsFewerThanFifteenObserversInformal) {
    auto study = laboratory();
    study.panel.required = 14;
    EXPECT_EQ(line(study, "15 observers").verdict, Verdict::NotMet);
    EXPECT_THAT(line(study, "15 observers").because, HasSubstr("informal"));
    study.panel.required = 15;
    EXPECT_EQ(line(study, "15 observers", {14}).verdict, Verdict::NotMet);
    EXPECT_THAT(line(study, "15 observers", {14}).because, HasSubstr("informal"));
    EXPECT_EQ(line(study, "15 observers", {15}).verdict, Verdict::Met);
}

TEST(Conformity, CountsTheMinutesOfASession) {
    auto study = laboratory();
    study.plan.repetitions = 13; // 3 scenes, 6 pairs: 234 + 7 trials of 8 s and a minute
    EXPECT_EQ(line(study, "30 minutes").verdict, Verdict::NotMet);
    EXPECT_THAT(line(study, "30 minutes").because, HasSubstr("33 minutes"));
}

} // namespace
