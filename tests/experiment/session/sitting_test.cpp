#include "experiment/session/sitting.h"
#include "tests/experiment/session/scripted_sitting.h"

namespace {

using namespace experiment::session;
using testing::ElementsAre;
using testing::IsEmpty;
using tests::ScriptedSitting;
using tests::short_script;

TEST(Sitting, GoesFromTheFirstPageToThanks) {
    ScriptedSitting sitting(short_script());
    sitting.press(2000, Key::Forward);
    sitting.press(4100, Key::Forward);
    sitting.wait_until(4600);
    sitting.press(5610, Key::Right);
    sitting.press(9000, Key::Release);
    sitting.wait_until(10000);
    sitting.wait_until(10500);
    sitting.press(11510, Key::Left);
    sitting.wait_until(12010);
    sitting.press(13020, Key::Left);
    sitting.wait_until(13520);
    sitting.press(15530, Key::Right);
    sitting.wait_until(16030);
    sitting.press(17041, Key::Left, Device::Mouse);
    sitting.press(20000, Key::Forward);
    EXPECT_THAT(sitting.diary(), ElementsAre("0 page Welcome",                               //
                                             "2000 event page instructions 1 of 2: 2000 ms", //
                                             "2000 page How to answer",
                                             "4100 event page instructions 2 of 2: 2100 ms",
                                             "4100 grey",                  //
                                             "4600 pair 1",                // training
                                             "4610 shown 1 #1 late 10 ms", //
                                             "5610 page # Any questions?", //
                                             "9000 event page questions: 3390 ms",
                                             "9000 grey", // adaptation
                                             "10000 event adaptation 1000 ms",
                                             "10000 grey",                  //
                                             "10500 pair 2",                // warm-up
                                             "10510 shown 2 #1 late 10 ms", //
                                             "11510 grey",                  //
                                             "12010 pair 3",                // main
                                             "12020 shown 3 #1 late 10 ms", //
                                             "13020 vote 3 left 1000 ms early 0",
                                             "13020 grey",                  //
                                             "13520 pair 4",                //
                                             "13530 shown 4 #1 late 10 ms", //
                                             "15530 vote 4 right 2000 ms early 0",
                                             "15530 grey",                  //
                                             "16030 pair 5",                //
                                             "16040 shown 5 #1 late 10 ms", //
                                             "17041 vote 5 left 1001 ms early 0",
                                             "17041 finish",            //
                                             "17041 page # Thank you!", //
                                             "20000 end finished"));
}

TEST(Sitting, TurnsNoPageBeforeItCanHaveBeenRead) {
    ScriptedSitting sitting(short_script());
    sitting.press(100, Key::Forward);
    sitting.press(1999, Key::Forward);
    EXPECT_THAT(sitting.diary(), ElementsAre("0 page Welcome"));
}

TEST(Sitting, LeavesTheQuestionsToTheExperimenter) {
    ScriptedSitting sitting(short_script());
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    sitting.wait_until(4500);
    sitting.press(5000, Key::Left);
    sitting.news();
    sitting.press(9000, Key::Forward);
    sitting.press(9100, Key::Left);
    EXPECT_THAT(sitting.news(), IsEmpty());
    sitting.press(9200, Key::Release);
    EXPECT_THAT(sitting.news(), ElementsAre("9200 event page questions: 4200 ms", "9200 grey"));
}

TEST(Sitting, CountsAnswersThatComeTooEarlyAndTakesNone) {
    ScriptedSitting sitting(short_script());
    sitting.pass_to_warm_up();
    sitting.wait_until(7500);
    sitting.press(8000, Key::Left); // the warm-up; grey until 8500
    sitting.news();
    sitting.press(8100, Key::Left);
    sitting.wait_until(8500); // the pair's onset is at 8510, input opens at 8810
    sitting.press(8505, Key::Right);
    sitting.press(8809, Key::Right);
    sitting.press(8810, Key::Left);
    EXPECT_THAT(sitting.news(), ElementsAre("8500 pair 3", "8510 shown 3 #1 late 10 ms",
                                            "8810 vote 3 left 300 ms early 3", "8810 grey"));
}

TEST(Sitting, StartsCountingEarlyAnswersAnewForEveryTrial) {
    ScriptedSitting sitting(short_script());
    sitting.pass_to_warm_up();
    sitting.wait_until(7500);
    sitting.press(7600, Key::Left);
    sitting.press(8000, Key::Left);
    sitting.wait_until(8500);
    sitting.news();
    sitting.press(9000, Key::Left);
    EXPECT_THAT(sitting.news(), ElementsAre("9000 vote 3 left 490 ms early 0", "9000 grey"));
}

TEST(Sitting, TakesNoAnswerFromAKeyThatIsHeld) {
    ScriptedSitting sitting(short_script());
    sitting.pass_to_warm_up();
    sitting.wait_until(7500);
    sitting.press(8000, Key::Left);
    sitting.news();
    sitting.press(8100, Key::Right); // and let go
    sitting.wait_until(8500);
    for (long long ms = 8520; ms < 9500; ms += 33)
        sitting.repeat(ms, Key::Left);
    EXPECT_THAT(sitting.news(), ElementsAre("8500 pair 3", "8510 shown 3 #1 late 10 ms"));
    sitting.press(9510, Key::Right);
    EXPECT_THAT(sitting.news(), ElementsAre("9510 vote 3 right 1000 ms early 1", "9510 grey"));
}

TEST(Sitting, MarksAnAnswerWhoseKeyWasDownAtTheOnset) {
    Sitting sitting({{"page"},
                     "?",
                     tests::short_script().plan,
                     {{1, protocols::Phase::Main, {{"a"}, {}, {"x"}, {"y"}}}}},
                    {});
    const auto at = [](int ms) { return std::chrono::milliseconds(ms); };
    sitting.begin(at(0));
    sitting.advance({at(2000), Pressed{Key::Forward}});
    sitting.advance({at(2001), Pressed{Key::Release}});
    sitting.advance({at(3001), Waited{}});
    sitting.advance({at(3100), Pressed{Key::Left}});
    sitting.advance({at(3501), Waited{}});
    sitting.advance({at(3502), OnsetSeen{"scripted"}});
    sitting.advance({at(4000), LetGo{Key::Left}});
    EXPECT_TRUE(sitting.advance({at(4502), Pressed{Key::Left}}).empty());
    const auto effects = sitting.advance({at(4512), Waited{}});
    ASSERT_EQ(effects.size(), 1u);
    const auto vote = std::get<experiment::store::MainVote>(effects[0]);
    EXPECT_TRUE(vote.held_key);
    EXPECT_EQ(vote.early_keys, 1);
    EXPECT_EQ(vote.response_time, at(1000));
}

TEST(Sitting, ShowsNothingAfterAVoteUntilItIsStored) {
    Sitting sitting({{"page"},
                     "?",
                     tests::short_script().plan,
                     {{1, protocols::Phase::Main, {{"a"}, {}, {"x"}, {"y"}}},
                      {2, protocols::Phase::Main, {{"b"}, {}, {"x"}, {"y"}}}}},
                    {});
    const auto at = [](int ms) { return std::chrono::milliseconds(ms); };
    sitting.begin(at(0));
    sitting.advance({at(2000), Pressed{Key::Forward}});
    sitting.advance({at(2001), Pressed{Key::Release}});
    sitting.advance({at(3001), Waited{}});
    sitting.advance({at(3501), Waited{}});
    sitting.advance({at(3502), OnsetSeen{"scripted"}});
    sitting.advance({at(4000), Pressed{Key::Left}});
    EXPECT_EQ(sitting.wake_at(), at(4010));
    ASSERT_EQ(sitting.advance({at(4010), Waited{}}).size(), 1u);
    EXPECT_EQ(sitting.view(), View(GreyView{}));
    EXPECT_EQ(sitting.wake_at(), std::nullopt);
    sitting.advance({at(9000), Waited{}});
    EXPECT_EQ(sitting.view(), View(GreyView{}));
    sitting.advance({at(9100), VoteStored{}});
    EXPECT_EQ(sitting.wake_at(), at(9600));
    sitting.advance({at(9103), OnsetSeen{"scripted"}});
    EXPECT_EQ(sitting.wake_at(), at(9603)); // the grey counts from when it is seen
}

TEST(Sitting, SaysHowMuchLongerTheGreyWasThanPlanned) {
    ScriptedSitting sitting(short_script(), {}, 250);
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    sitting.news();
    sitting.wait_until(4520);
    EXPECT_THAT(sitting.news(), ElementsAre("4520 pair 1", "4770 shown 1 #1 late 270 ms"));
}

TEST(Sitting, NamesTheNextPairWhileThereIsTimeToMakeItReady) {
    ScriptedSitting sitting(short_script());
    EXPECT_EQ(sitting.sitting().upcoming()->number, 1);
    sitting.press(2000, Key::Forward);
    sitting.press(4000, Key::Forward);
    EXPECT_EQ(sitting.sitting().upcoming()->number, 1);
    sitting.wait_until(4500);
    EXPECT_EQ(sitting.sitting().upcoming()->number, 2);
}

TEST(Sitting, OffersABreakAfterSoManyTrials) {
    ScriptedSitting sitting(short_script(2));
    sitting.pass_to_warm_up();
    sitting.wait_until(7500);
    sitting.press(8000, Key::Left);
    sitting.wait_until(8500);
    sitting.press(9000, Key::Left);
    sitting.wait_until(9500);
    sitting.news();
    sitting.press(10000, Key::Left);
    EXPECT_THAT(sitting.news(),
                ElementsAre("10000 vote 4 left 490 ms early 0", "10000 page # Time for a break"));
    sitting.press(19999, Key::Forward);
    EXPECT_THAT(sitting.news(), IsEmpty());
    sitting.press(20000, Key::Forward);
    EXPECT_THAT(sitting.news(), ElementsAre("20000 event break 10000 ms", "20000 grey"));
}

TEST(Sitting, OffersABreakAfterTenMinutes) {
    ScriptedSitting sitting(short_script(50));
    sitting.pass_to_warm_up();
    sitting.wait_until(7500);
    sitting.press(8000, Key::Left);
    sitting.wait_until(8500);
    sitting.news();
    sitting.press(8000 + 600'000, Key::Left);
    EXPECT_THAT(sitting.news(), ElementsAre("608000 vote 3 left 599490 ms early 0",
                                            "608000 page # Time for a break"));
}

} // namespace
