#include "experiment/session/sitting.h"
#include "tests/experiment/session/scripted_sitting.h"

namespace {

using namespace experiment::session;
using testing::ElementsAre;
using testing::IsEmpty;
using tests::ScriptedSitting;
using tests::short_script;

// A sitting whose first main pair is on the screen since 8510 ms.
ScriptedSitting at_first_main_pair() {
    ScriptedSitting sitting(short_script());
    sitting.pass_to_warm_up();
    sitting.wait_until(7500);
    sitting.press(8000, Key::Left);
    sitting.wait_until(8500);
    sitting.news();
    return sitting;
}

TEST(Interruption, ByEscapeAsksAndCanBeTakenBack) {
    auto sitting = at_first_main_pair();
    sitting.press(9000, Key::Escape);
    sitting.press(9100, Key::Left);
    sitting.press(9200, Key::Forward); // too soon to be meant
    sitting.press(9600, Key::Forward);
    sitting.wait_until(10100);
    sitting.press(10600, Key::Left);
    EXPECT_THAT(sitting.news(),
                ElementsAre("9000 event stop_asked trial 3",
                            "9000 page # Do you want to stop here?", "9600 event continued ",
                            "9600 grey", "10100 pair 3", "10110 shown 3 #2 late 10 ms",
                            "10600 vote 3 left 490 ms early 0", "10600 grey"));
}

TEST(Interruption, ByEscapeTwiceStopsTheSitting) {
    auto sitting = at_first_main_pair();
    sitting.press(9000, Key::Escape);
    sitting.press(9499, Key::Escape); // a key that bounces is no decision
    sitting.press(9500, Key::Escape);
    EXPECT_THAT(sitting.news(), ElementsAre("9000 event stop_asked trial 3",
                                            "9000 page # Do you want to stop here?",
                                            "9500 event stopped ", "9500 end stopped"));
}

TEST(Interruption, ByTheWindowsCloseButtonIsLikeEscape) {
    auto sitting = at_first_main_pair();
    sitting.close(9000);
    sitting.close(9600);
    EXPECT_THAT(sitting.news(), ElementsAre("9000 event stop_asked trial 3",
                                            "9000 page # Do you want to stop here?",
                                            "9600 event stopped ", "9600 end stopped"));
}

TEST(Interruption, OfAPageLeadsBackToThatPage) {
    ScriptedSitting sitting(short_script());
    sitting.press(1000, Key::Escape);
    sitting.press(1600, Key::Forward);
    sitting.press(2000, Key::Forward);
    EXPECT_THAT(sitting.news(),
                ElementsAre("0 page Welcome", "1000 event stop_asked ",
                            "1000 page # Do you want to stop here?", "1600 event continued ",
                            "1600 page Welcome", "2000 event page instructions 1 of 2: 2000 ms",
                            "2000 page How to answer"));
}

TEST(Interruption, OfTheAdaptationDoesNotLengthenIt) {
    ScriptedSitting sitting(short_script());
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    sitting.wait_until(4500);
    sitting.press(5000, Key::Left);
    sitting.press(6000, Key::Release);
    sitting.press(6100, Key::Escape);
    sitting.press(6700, Key::Forward);
    sitting.news();
    EXPECT_TRUE(sitting.sitting().wake_at().has_value());
    sitting.wait_until(6999);
    EXPECT_THAT(sitting.news(), IsEmpty());
    sitting.wait_until(7000);
    EXPECT_THAT(sitting.news(), ElementsAre("7000 event adaptation 1000 ms", "7000 grey"));
}

TEST(Interruption, ByALossOfTheKeyboardWaitsForTheExperimenter) {
    auto sitting = at_first_main_pair();
    sitting.lose_focus(9000);
    sitting.press(9100, Key::Left);
    sitting.press(9200, Key::Forward);
    sitting.press(9300, Key::Escape);
    sitting.press(9900, Key::Forward);
    sitting.press(10000, Key::Release);
    sitting.wait_until(10500);
    EXPECT_THAT(sitting.news(),
                ElementsAre("9000 event paused trial 3", "9000 page # Paused",
                            "9300 event stop_asked ", "9300 page # Do you want to stop here?",
                            "9900 event continued ", "9900 page # Paused", "10000 event continued ",
                            "10000 grey", "10500 pair 3", "10510 shown 3 #2 late 10 ms"));
}

TEST(Interruption, ByALossOfTheKeyboardDoesNotTurnPages) {
    ScriptedSitting sitting(short_script());
    sitting.lose_focus(500);
    EXPECT_THAT(sitting.diary(), ElementsAre("0 page Welcome"));
}

TEST(Interruption, CannotStopWhatIsFinished) {
    auto sitting = at_first_main_pair();
    sitting.press(9000, Key::Left);
    sitting.wait_until(9500);
    sitting.press(10000, Key::Left);
    sitting.wait_until(10500);
    sitting.press(11000, Key::Left);
    sitting.news();
    sitting.press(12000, Key::Escape);
    EXPECT_THAT(sitting.news(), ElementsAre("12000 end finished"));
}

TEST(Resumption, ShowsWarmUpsAgainAndTheTrialsWithoutAVote) {
    Progress progress;
    progress.training_done = true;
    progress.voted = {3};
    progress.presentations = {{1, 1}, {2, 1}, {3, 1}, {4, 2}};
    ScriptedSitting sitting(short_script(), progress);
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    sitting.press(5000, Key::Release);
    sitting.wait_until(6000);
    sitting.wait_until(6500);
    sitting.press(7000, Key::Left);
    sitting.wait_until(7500);
    sitting.press(8000, Key::Right);
    sitting.wait_until(8500);
    sitting.press(9000, Key::Right);
    EXPECT_THAT(
        sitting.diary(),
        ElementsAre("0 page Welcome", "2000 event page instructions 1 of 2: 2000 ms",
                    "2000 page How to answer", "4000 event page instructions 2 of 2: 2000 ms",
                    "4000 page # Any questions?", "5000 event page questions: 1000 ms", "5000 grey",
                    "6000 event adaptation 1000 ms", "6000 grey", "6500 pair 2",
                    "6510 shown 2 #2 late 10 ms", "7000 grey", "7500 pair 4",
                    "7510 shown 4 #3 late 10 ms", "8000 vote 4 right 490 ms early 0", "8000 grey",
                    "8500 pair 5", "8510 shown 5 #1 late 10 ms", "9000 vote 5 right 490 ms early 0",
                    "9000 finish", "9000 page # Thank you!"));
}

TEST(Resumption, RepeatsATrainingThatWasNotDone) {
    Progress progress;
    progress.presentations = {{1, 1}};
    ScriptedSitting sitting(short_script(), progress);
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    sitting.news();
    sitting.wait_until(4500);
    EXPECT_THAT(sitting.news(), ElementsAre("4500 pair 1", "4510 shown 1 #2 late 10 ms"));
}

TEST(Resumption, OfACompleteSittingOnlyFinishesIt) {
    Progress progress;
    progress.voted = {3, 4, 5};
    EXPECT_THAT(ScriptedSitting(short_script(), progress).diary(),
                ElementsAre("0 finish", "0 page # Thank you!"));
}

} // namespace
