// What a sitting can be asked to do beyond two pictures and two keys.
#include "tests/experiment/session/scripted_sitting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace experiment::session;
using protocols::Presentation;
using protocols::Response;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tests::ScriptedSitting;
using tests::short_script;

/// The first main trial (number 3) is on the screen since 8010 ms.
ScriptedSitting at_first_main(SittingScript script = short_script()) {
    ScriptedSitting sitting(std::move(script));
    sitting.pass_to_warm_up(); // 7000
    sitting.wait_until(7500);  // onset at 7510
    sitting.press(7900, Key::Left);
    sitting.wait_until(8400); // onset at 8410
    sitting.news();
    return sitting;
}

TEST(TwoAnswersAtOnce, AreNoneAndThePairComesAgainLater) {
    auto sitting = at_first_main();
    sitting.press_both(9000, Key::Left, 9009, Key::Right);
    EXPECT_THAT(sitting.news(),
                ElementsAre("9009 event ambiguous trial 3: two answers at once", "9009 grey"));
    sitting.wait_until(9509);
    sitting.press(10000, Key::Left);
    sitting.wait_until(10500);
    sitting.press(11000, Key::Left);
    sitting.wait_until(11500);
    sitting.press(12000, Key::Right);
    const auto diary = sitting.news();
    EXPECT_THAT(diary, Contains(HasSubstr("vote 4 left")));
    EXPECT_THAT(diary, Contains(HasSubstr("vote 3 ")));
    EXPECT_THAT(diary, Contains(HasSubstr("vote 5 ")));
    EXPECT_THAT(diary, Contains(HasSubstr("shown 3 #2")));
    EXPECT_THAT(diary, Contains(HasSubstr("finish")));
}

TEST(TwoAnswersAtOnce, AreTwoTenMillisecondsLater) {
    auto sitting = at_first_main();
    sitting.press_both(9000, Key::Left, 9010, Key::Right);
    EXPECT_THAT(sitting.news(), Contains(HasSubstr("vote 3 left")));
}

TEST(AnAnswer, StandsEvenIfTheWindowIsLostInTheSameMoment) {
    auto sitting = at_first_main();
    sitting.press_then_lose_focus(9000, Key::Right, 9005);
    const auto diary = sitting.news();
    EXPECT_THAT(diary, Contains(HasSubstr("vote 3 right")));
    EXPECT_THAT(diary, Contains(HasSubstr("event paused trial 4")));
}

TEST(Training, IsRepeatedUntilTheObserverIsReady) {
    ScriptedSitting sitting(short_script());
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    for (int round = 0; round < 3; ++round) {
        const auto start = 4000 + round * 2000;
        sitting.news();
        sitting.wait_until(start + 500);
        sitting.press(start + 1000, Key::Left);
        EXPECT_THAT(sitting.news(), Contains(HasSubstr("page # Any questions?")));
        sitting.press(start + 2000, Key::Again);
        EXPECT_THAT(sitting.news(), Contains(HasSubstr("event training_again")));
    }
    EXPECT_THAT(sitting.diary(), Contains(HasSubstr("shown 1 #3")));
    sitting.wait_until(10500);
    sitting.press(11000, Key::Left);
    sitting.press(12000, Key::Release);
    sitting.news();
    sitting.press(12500, Key::Again); // too late: nothing comes of it
    EXPECT_THAT(sitting.news(), IsEmpty());
}

TEST(Exposure, EndsAfterViewMsAndTheAnswerIsStillTaken) {
    auto script = short_script();
    script.plan.view_ms = 400;
    ScriptedSitting sitting(script);
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    sitting.wait_until(4500); // onset at 4510
    sitting.news();
    sitting.wait_until(4900);
    EXPECT_THAT(sitting.news(), IsEmpty());
    sitting.wait_until(4910);
    EXPECT_THAT(sitting.news(), ElementsAre("4910 grey"));
    sitting.press(6000, Key::Left);
    EXPECT_THAT(sitting.news(), ElementsAre(HasSubstr("page # Any questions?")));
}

TEST(NotSure, IsAnAnswerOnlyWhereItIsOffered) {
    auto forced = at_first_main();
    forced.press(9000, Key::NotSure);
    EXPECT_THAT(forced.news(), IsEmpty());
    auto script = short_script();
    script.plan.response = Response::WithNotSure;
    auto free = at_first_main(script);
    free.press(9000, Key::NotSure);
    EXPECT_THAT(free.news(), Contains(HasSubstr("vote 3 not_sure")));
}

TEST(Grades, AreSevenKeysAndNoOthers) {
    auto script = short_script();
    script.plan.response = Response::SevenGrades;
    ScriptedSitting sitting(script);
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    sitting.wait_until(4500);
    sitting.news();
    sitting.press(5000, Key::Left);
    EXPECT_THAT(sitting.news(), IsEmpty());
    sitting.press(5500, Key::MuchBetter);
    EXPECT_THAT(sitting.news(), ElementsAre(HasSubstr("page # Any questions?")));
    EXPECT_EQ(grade_of(Key::MuchWorse), -3);
    EXPECT_EQ(grade_of(Key::Same), 0);
    EXPECT_EQ(grade_of(Key::MuchBetter), 3);
    EXPECT_EQ(grade_of(Key::Left), std::nullopt);
    // Said of the right picture: better means right.
    EXPECT_EQ(choice_of(Key::SlightlyBetter), protocols::Choice::Right);
    EXPECT_EQ(choice_of(Key::SlightlyWorse), protocols::Choice::Left);
    EXPECT_EQ(choice_of(Key::Same), protocols::Choice::Tie);
}

TEST(Sequence, ShowsOneThenTheOtherAndTakesAnswersAfterBoth) {
    auto script = short_script();
    script.plan.presentation = Presentation::Sequential;
    script.plan.view_ms = 1000;
    script.plan.between_ms = 200;
    ScriptedSitting sitting(script);
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    sitting.news();
    sitting.wait_until(4500); // onset at 4510
    sitting.press(5000, Key::Left);
    sitting.wait_until(5510);
    sitting.wait_until(5710); // the between grey's own onset is not told here
    EXPECT_THAT(sitting.news(),
                ElementsAre("4500 pair 1 first", HasSubstr("shown 1 #1"), "5510 grey"));
}

TEST(Flip, ShowsTheOtherPictureAtTheObserversWish) {
    auto script = short_script();
    script.plan.presentation = Presentation::Flip;
    ScriptedSitting sitting(script);
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    sitting.news();
    sitting.wait_until(4500);
    sitting.press(5000, Key::Right); // only one of them was seen
    sitting.press(5100, Key::Flip);  // onset at 5110
    sitting.press(5200, Key::Right); // input is still closed
    sitting.press(6000, Key::Flip);
    EXPECT_THAT(sitting.news(), ElementsAre("4500 pair 1 first", HasSubstr("shown 1 #1"),
                                            "5100 pair 1 second", "6000 pair 1 first"));
    sitting.press(6500, Key::Right);
    EXPECT_THAT(sitting.news(), ElementsAre(HasSubstr("page # Any questions?")));
}

TEST(AScreenThatChanges, PausesTheTrialUntilTheExperimenterGoesOn) {
    auto sitting = at_first_main();
    sitting.change_display(9000, "the monitor is gone");
    EXPECT_THAT(sitting.news(),
                ElementsAre("9000 event display_changed the monitor is gone",
                            "9000 event paused_by_display trial 3", "9000 page # Paused"));
    sitting.press(9500, Key::Left);
    EXPECT_THAT(sitting.news(), IsEmpty());
    sitting.press(9600, Key::Release);
    sitting.wait_until(10100);
    sitting.press(10600, Key::Left);
    EXPECT_THAT(sitting.news(), Contains(HasSubstr("vote 3 left")));
}

TEST(ALongSitting, IsTheExperimentersToGoOnWith) {
    auto script = short_script();
    script.plan.longest_minutes = 1;
    auto sitting = at_first_main(script);
    sitting.press(61000, Key::Left);
    const auto diary = sitting.news();
    EXPECT_THAT(diary, Contains(HasSubstr("vote 3 left")));
    EXPECT_THAT(diary, Contains(HasSubstr("event limit_reached")));
    EXPECT_THAT(diary, Contains("61000 page # That is long enough"));
    sitting.press(62000, Key::Forward);
    EXPECT_THAT(sitting.news(), IsEmpty());
    sitting.press(63000, Key::Release);
    EXPECT_THAT(sitting.news(), ElementsAre("63000 event limit_passed ", "63000 grey"));
    sitting.wait_until(63500);
    sitting.press(64000, Key::Left);
    EXPECT_THAT(sitting.news(), Contains(HasSubstr("vote 4 left"))); // asked once only
}

TEST(ALongSitting, CanBeStoppedAndTakenUpAgain) {
    auto script = short_script();
    script.plan.longest_minutes = 1;
    auto sitting = at_first_main(script);
    sitting.press(61000, Key::Left);
    sitting.press(62000, Key::Escape);
    sitting.press(63000, Key::Escape);
    EXPECT_EQ(sitting.diary().back(), "63000 end stopped");
}

SittingScript hurried(protocols::AfterDeadline after) {
    auto script = short_script();
    script.plan.deadline_s = 2;
    script.plan.after_deadline = after;
    return script;
}

TEST(ADeadline, LetsAPairComeOnceMoreLaterAndThenStayUnanswered) {
    auto sitting = at_first_main(hurried(protocols::AfterDeadline::Again)); // onset at 8410
    sitting.wait_until(10409);
    EXPECT_THAT(sitting.news(), IsEmpty());
    sitting.wait_until(10410);
    EXPECT_THAT(sitting.news(), ElementsAre("10410 event deadline trial 3", "10410 grey"));
    sitting.wait_until(10910);
    sitting.press(11500, Key::Left); // number 4
    sitting.wait_until(12000);
    sitting.press(12500, Key::Left); // number 5
    sitting.wait_until(13000);       // number 3 again, onset at 13010
    EXPECT_THAT(sitting.news(), Contains(HasSubstr("shown 3 #2")));
    sitting.wait_until(15010);
    EXPECT_THAT(sitting.news(), ElementsAre("15010 event deadline trial 3", "15010 event missing 3",
                                            "15010 finish", HasSubstr("page # Thank you")));
    EXPECT_EQ(sitting.sitting().standing(std::chrono::seconds(15)).answered, 2);
}

TEST(ADeadline, LeavesAPairUnansweredWhereTheStudyWantsThat) {
    auto sitting = at_first_main(hurried(protocols::AfterDeadline::Missing));
    sitting.wait_until(10410);
    EXPECT_THAT(sitting.news(),
                ElementsAre("10410 event deadline trial 3", "10410 event missing 3", "10410 grey"));
    sitting.wait_until(10910);
    EXPECT_THAT(sitting.news(), Contains(HasSubstr("pair 4")));
}

TEST(ADeadline, TakesTheAnswerThatComesJustBeforeItAndNoneThatComesAt) {
    auto before = at_first_main(hurried(protocols::AfterDeadline::Missing));
    before.press(10409, Key::Left);
    EXPECT_THAT(before.news(), Contains(HasSubstr("vote 3 left 1999 ms")));
    auto after = at_first_main(hurried(protocols::AfterDeadline::Missing));
    after.press(10410, Key::Left);
    EXPECT_THAT(after.news(), Contains(HasSubstr("event missing 3")));
}

TEST(ADeadline, PassesOverAPairOfThePractice) {
    ScriptedSitting sitting(hurried(protocols::AfterDeadline::Again));
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    sitting.wait_until(4500); // onset at 4510
    sitting.news();
    sitting.wait_until(6510);
    EXPECT_THAT(sitting.news(),
                ElementsAre("6510 event deadline trial 1", HasSubstr("page # Any questions?")));
}

TEST(Resumption, DoesNotAskAgainWhatIsOnRecordAsMissing) {
    Progress progress;
    progress.training_done = true;
    progress.voted = {4};
    progress.missing = {3};
    const ScriptedSitting sitting(short_script(), progress);
    const auto standing = sitting.sitting().standing(std::chrono::seconds(0));
    EXPECT_EQ(standing.answered, 1);
    EXPECT_EQ(standing.main, 2); // number 5 is still to come
}

} // namespace
