// Observers as a laboratory keeps them: registered, screened, sat twice on two days, withdrawn.
#include "experiment/store/sqlite_store.h"
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"

#include <algorithm>
#include <map>

namespace {

using namespace tests;
using testing::HasSubstr;

class Observers : public testing::Test {
  protected:
    void SetUp() override {
        write_small_study(folder.path());
        const auto file = folder / "study.toml";
        write_file(file, read_file(file) +
                             "\n[observer]\nquestions = \"own\"\n\n[[question]]\nid = "
                             "\"acuity\"\nask = \"Acuity\"\nleast = 0\ngreatest = "
                             "3\npasses_from = 0.67\n");
    }

    Outcome program(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin() + 1, folder.path().string());
        return pairlight(arguments);
    }

    TemporaryFolder folder;
};

TEST_F(Observers, AreRegisteredWithConsentAndScreening) {
    EXPECT_THAT(program({"register", "--answer", "acuity=1"}).err, HasSubstr("--consent"));
    EXPECT_THAT(program({"register", "--consent"}).err, HasSubstr("question \"acuity\""));
    EXPECT_THAT(program({"register", "--consent", "--answer", "acuity=9"}).err,
                HasSubstr("a number from 0 to 3"));
    EXPECT_FALSE(std::filesystem::exists(folder / "votes.sqlite")) << "a refusal left a store";
    const auto drawn = program({"register", "--consent", "--answer", "acuity=1.0"});
    EXPECT_EQ(drawn.status, 0) << drawn.err;
    EXPECT_THAT(drawn.out, testing::MatchesRegex("P[A-Z2-9]{4}: registered; screening passed\n"));
    const auto named =
        program({"register", "--observer", "P1", "--consent", "--answer", "acuity=0.5"});
    EXPECT_THAT(named.out, HasSubstr("P1: registered; screening failed: acuity"));
    EXPECT_THAT(program({"observers"}).out, HasSubstr("P1: 0 of 1 sittings finished"));
    EXPECT_EQ(program({"verify"}).status, 0);
}

TEST_F(Observers, AreNotRegisteredByHalf) {
    const auto nameless =
        program({"register", "--observer", "", "--consent", "--answer", "acuity=1"});
    EXPECT_NE(nameless.status, 0);
    EXPECT_THAT(nameless.err, HasSubstr("or no --observer to draw one"));
    const auto undecided =
        program({"register", "--consent", "--answer", "acuity=1", "--answer", "acuity=0.5"});
    EXPECT_NE(undecided.status, 0);
    EXPECT_THAT(undecided.err, HasSubstr("has the answer \"1\" already"));
    EXPECT_FALSE(std::filesystem::exists(folder / "votes.sqlite")) << "a refusal left a store";
}

TEST_F(Observers, AreNotAskedWhatTheStudyDoesNotAsk) {
    write_small_study(folder.path());
    const auto asked = program({"register", "--observer", "P1", "--answer", "acuity=1"});
    EXPECT_NE(asked.status, 0);
    EXPECT_THAT(asked.err, testing::AllOf(HasSubstr("--answer acuity=1: " + folder.path().string() +
                                                    " asks its observers nothing"),
                                          HasSubstr("expected no --answer")));
    EXPECT_FALSE(std::filesystem::exists(folder / "votes.sqlite")) << "a refusal left a store";
    EXPECT_EQ(program({"register", "--observer", "P1"}).status, 0);
}

TEST_F(Observers, LeaveForAReasonAndSitSoonerForOne) {
    ASSERT_EQ(program({"session", "--observer", "S1", "--simulate", ""}).status, 0);
    const auto gone = program({"withdraw", "--observer", "S1", "--reason", " ", "--for-good"});
    EXPECT_NE(gone.status, 0);
    EXPECT_THAT(gone.err, HasSubstr("\" \" says nothing, expected a reason"));
    EXPECT_THAT(program({"observers"}).out, HasSubstr("S1 (SIMULATED): 1 of 1"));
    EXPECT_THAT(program({"session", "--observer", "P1", "--override-days", ""}).err,
                HasSubstr("\"\" says nothing, expected a reason"));
}

TEST_F(Observers, InNeighbouringPlacesSeeEachPairEitherWayRound) {
    ASSERT_EQ(program({"simulate", "--observers", "4", "--quiet"}).status, 0);
    const auto votes = *(*experiment::store::open_votes(folder / "votes.sqlite"))->votes();
    ASSERT_EQ(votes.size(), 4u * pairs_asked);
    std::map<std::string, int> left_minus_right;
    for (const auto& vote : votes) {
        const auto [low, high] = std::minmax(vote.pair.left.value, vote.pair.right.value);
        left_minus_right[vote.pair.scene.value + ' ' + low + ' ' + high] +=
            vote.pair.left.value == low ? 1 : -1;
    }
    EXPECT_EQ(left_minus_right.size(), static_cast<std::size_t>(pairs_asked));
    for (const auto& [pair, difference] : left_minus_right)
        EXPECT_EQ(difference, 0) << pair;
    // The schedule knows whom an observer mirrors.
    const auto schedule = program({"schedule", "--observer", "sim-02", "--quiet"}).out;
    for (const auto& vote : votes)
        if (vote.observer.value == "sim-02") {
            EXPECT_THAT(schedule, HasSubstr("main," + vote.pair.scene.value + ",," +
                                            vote.pair.left.value + "," + vote.pair.right.value));
        }
}

TEST_F(Observers, DoNotSitBeforeTheyAreRegistered) {
    const auto refused = program({"session", "--observer", "P1"});
    EXPECT_NE(refused.status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "votes.sqlite"));
}

TEST_F(Observers, AreRemovedAtTheirWishAndLeaveATombstone) {
    for (const auto* observer : {"S1", "S2"})
        ASSERT_EQ(program({"session", "--observer", observer, "--simulate", ""}).status, 0);
    EXPECT_THAT(program({"withdraw", "--observer", "S1", "--reason", "asked to"}).err,
                HasSubstr("--for-good"));
    const auto gone =
        program({"withdraw", "--observer", "S1", "--reason", "asked to", "--for-good"});
    EXPECT_EQ(gone.status, 0) << gone.err;
    EXPECT_THAT(gone.out, HasSubstr("6 votes"));
    EXPECT_EQ(program({"verify"}).status, 0);
    EXPECT_THAT(program({"observers"}).out, HasSubstr("withdrawn on"));
    EXPECT_THAT(program({"export", "--format", "long"}).out, testing::Not(HasSubstr(",S1,")));
    EXPECT_NE(program({"session", "--observer", "S1", "--simulate", ""}).status, 0);
    EXPECT_EQ(program({"session", "--observer", "S2", "--simulate", ""}).status, 1); // finished
}

TEST_F(Observers, SeeConformityLineByLine) {
    const auto checked = program({"check"});
    EXPECT_EQ(checked.status, 0) << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("ITU-R BT.500:"));
    EXPECT_THAT(checked.out, HasSubstr("NOT MET                         colour vision tested"));
    EXPECT_THAT(checked.out, HasSubstr("only the experimenter can know"));
}

TEST_F(Observers, TakeAPhotometersMeasurements) {
    write_file(folder / "measured.csv",
               "code,cd_m2\n0,0.1\n32,1.3\n64,5.2\n96,12.9\n128,24.6\n160,40.6\n192,61\n224,86.2\n"
               "255,115\n");
    const auto fit = program({"photometer", "--csv", (folder / "measured.csv").string()});
    EXPECT_EQ(fit.status, 0) << fit.err;
    EXPECT_THAT(fit.out, HasSubstr("gamma 2.2"));
    EXPECT_THAT(fit.out, HasSubstr("24.60 cd/m2, 21.4 % of white"));
    EXPECT_TRUE(std::filesystem::exists(folder / "calibration.csv"));
}

} // namespace
