#include "experiment/store/sqlite_store.h"
#include "tests/experiment/store/small_sitting.h"
#include "tests/experiment/store/temporary_folder.h"

namespace {

using namespace experiment::store;
using protocols::Choice;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tests::shown;
using tests::sitting_of;
using tests::vote;

class SqliteStore : public testing::Test {
  protected:
    std::unique_ptr<VoteStore> open() {
        auto store = open_or_create_votes(file_, tests::study);
        EXPECT_TRUE(store) << store.error();
        return store ? std::move(*store) : nullptr;
    }

    // A store with one begun sitting of P1.
    std::unique_ptr<VoteStore> begun() {
        auto store = open();
        EXPECT_TRUE(store->add_observer({"P1"}, "2026-03-01T08:59:00.000Z"));
        EXPECT_TRUE(store->begin_sitting(tests::start_of(p1_), tests::small_plan()));
        return store;
    }

    std::unique_ptr<VoteStore> finished() {
        auto store = begun();
        for (const int trial : {3, 4, 5}) {
            EXPECT_TRUE(store->append_shown(p1_, shown(trial)));
            EXPECT_TRUE(
                store->append_vote(p1_, vote(trial, trial == 4 ? Choice::Right : Choice::Left)));
        }
        EXPECT_TRUE(store->finish_sitting(p1_, "2026-03-01T09:10:00.000Z"));
        return store;
    }

    tests::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "votes.sqlite";
    SittingKey p1_ = sitting_of("P1");
};

TEST_F(SqliteStore, KeepsTheStudyItWasMadeFor) {
    EXPECT_EQ(open()->study(), tests::study);
    EXPECT_EQ((*open_votes(file_))->study(), tests::study);
}

TEST_F(SqliteStore, GivesASittingBackAsItWasWritten) {
    begun();
    const auto store = open();
    ASSERT_TRUE(store->append_shown(p1_, shown(3)));
    ASSERT_TRUE(store->append_vote(p1_, vote(3, Choice::Right)));
    const SittingEvent page{"page", "instructions 1, 5321 ms", 77, "2026-03-01T09:00:00.500Z"};
    ASSERT_TRUE(store->append_event(p1_, page));
    const auto sitting = store->sitting(p1_);
    ASSERT_TRUE(sitting && sitting->has_value());
    EXPECT_EQ((*sitting)->start, tests::start_of(p1_));
    ASSERT_EQ((*sitting)->plan.size(), 5u);
    EXPECT_EQ(plan_digest((*sitting)->plan), plan_digest(tests::small_plan()));
    EXPECT_THAT((*sitting)->shown, ElementsAre(shown(3)));
    EXPECT_THAT((*sitting)->votes, ElementsAre(vote(3, Choice::Right)));
    EXPECT_THAT((*sitting)->events, ElementsAre(page));
    EXPECT_EQ((*sitting)->finished_utc, std::nullopt);
}

TEST_F(SqliteStore, KnowsNothingOfSittingsThatWereNeverBegun) {
    const auto store = begun();
    EXPECT_EQ(store->sitting(sitting_of("P1", 2))->has_value(), false);
    EXPECT_THAT(store->append_shown(sitting_of("P2"), shown(3)).error(),
                HasSubstr("session 1 of observer P2 was never begun"));
}

TEST_F(SqliteStore, ReadsVotesAsWholeRows) {
    const auto rows = finished()->votes();
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), 3u);
    const VoteRow second{"glow",
                         {"P1"},
                         1,
                         4,
                         {{"bunny"}, {"back"}, {"phong"}, {"shss"}},
                         Choice::Right,
                         std::chrono::milliseconds(1234),
                         "2026-03-01T09:00:01.000Z",
                         false};
    EXPECT_EQ((*rows)[1], second);
}

TEST_F(SqliteStore, SummarisesSittings) {
    const auto summaries = finished()->sittings();
    ASSERT_TRUE(summaries);
    ASSERT_EQ(summaries->size(), 1u);
    EXPECT_EQ(summaries->front().key, p1_);
    EXPECT_EQ(summaries->front().local_date, "2026-03-01");
    EXPECT_EQ(summaries->front().votes, 3);
    EXPECT_EQ(summaries->front().finished_utc, "2026-03-01T09:10:00.000Z");
    EXPECT_EQ(summaries->front().simulation, std::nullopt);
}

TEST_F(SqliteStore, MarksSimulatedVotes) {
    const auto store = open();
    auto start = tests::start_of(sitting_of("S1"));
    start.simulation = "noise=1;seed=7";
    ASSERT_TRUE(store->add_observer({"S1"}, "2026-03-01T08:59:00.000Z"));
    ASSERT_TRUE(store->begin_sitting(start, tests::small_plan()));
    ASSERT_TRUE(store->append_shown(start.key, shown(3)));
    ASSERT_TRUE(store->append_vote(start.key, vote(3, Choice::Left)));
    EXPECT_TRUE(store->votes()->front().simulated);
    EXPECT_EQ(store->sittings()->front().simulation, "noise=1;seed=7");
}

TEST_F(SqliteStore, NeverMixesAPersonWithASimulation) {
    const auto store = finished();
    auto start = tests::start_of(sitting_of("P1", 2));
    start.simulation = "noise=1;seed=7";
    EXPECT_THAT(store->begin_sitting(start, tests::small_plan()).error(),
                HasSubstr("would be simulated, but session 1 was a person's"));
    EXPECT_EQ(store->sittings()->size(), 1u);
}

TEST_F(SqliteStore, RegistersAnObserverOnce) {
    const auto store = open();
    ASSERT_TRUE(store->add_observer({"P1"}, "2026-03-01T08:59:00.000Z"));
    ASSERT_TRUE(store->add_observer({"P2"}, "2026-03-01T08:59:00.000Z"));
    ASSERT_TRUE(store->add_observer({"P1"}, "2026-03-02T08:59:00.000Z"));
    EXPECT_THAT(*store->observers(),
                ElementsAre(protocols::ObserverId{"P1"}, protocols::ObserverId{"P2"}));
}

TEST_F(SqliteStore, RefusesWhatIsNoPseudonym) {
    const auto store = open();
    for (const auto* name : {"", "Ada Lovelace", "a/b", "123456789012345678901234567890123"})
        EXPECT_THAT(store->add_observer({name}, "2026-03-01T08:59:00.000Z").error(),
                    HasSubstr("expected a pseudonym of 1 to 32 letters"))
            << name;
    EXPECT_THAT(*store->observers(), IsEmpty());
}

TEST_F(SqliteStore, RefusesTheSittingOfAnUnknownObserverWhole) {
    const auto store = open();
    EXPECT_FALSE(store->begin_sitting(tests::start_of(p1_), tests::small_plan()));
    EXPECT_THAT(*store->sittings(), IsEmpty());
    EXPECT_THAT(*store->verify(), IsEmpty());
}

TEST_F(SqliteStore, DoesNotBeginAFinishedSittingAgain) {
    const auto store = finished();
    EXPECT_EQ(store->begin_sitting(tests::start_of(p1_), tests::small_plan()).error(),
              file_.string() + ": session 1 of observer P1 is finished (begun on 2026-03-01); its "
                               "votes stand, expected another session number");
    EXPECT_THAT(store->append_vote(p1_, vote(3, Choice::Left)).error(), HasSubstr("is finished"));
    EXPECT_THAT(store->append_event(p1_, {}).error(), HasSubstr("is finished"));
    EXPECT_EQ(store->votes()->size(), 3u);
}

TEST_F(SqliteStore, DoesNotBeginAnUnfinishedSittingAgain) {
    EXPECT_THAT(begun()->begin_sitting(tests::start_of(p1_), tests::small_plan()).error(),
                HasSubstr("was begun on 2026-03-01 and is not finished"));
}

TEST_F(SqliteStore, TakesVotesForMainTrialsThatWereShownAndOnlyOnce) {
    const auto store = begun();
    EXPECT_THAT(store->append_vote(p1_, vote(3, Choice::Left)).error(),
                HasSubstr("trial 3, which was not recorded as shown"));
    ASSERT_TRUE(store->append_shown(p1_, shown(1)));
    ASSERT_TRUE(store->append_shown(p1_, shown(2)));
    EXPECT_THAT(store->append_vote(p1_, vote(1, Choice::Left)).error(),
                HasSubstr("trial 1, which is training"));
    EXPECT_THAT(store->append_vote(p1_, vote(2, Choice::Left)).error(),
                HasSubstr("trial 2, which is warmup"));
    EXPECT_THAT(store->append_vote(p1_, vote(99, Choice::Left)).error(),
                HasSubstr("has no trial 99 in its plan"));
    ASSERT_TRUE(store->append_shown(p1_, shown(3)));
    ASSERT_TRUE(store->append_shown(p1_, shown(3, 2)));
    ASSERT_TRUE(store->append_vote(p1_, vote(3, Choice::Left)));
    EXPECT_THAT(store->append_vote(p1_, vote(3, Choice::Right)).error(),
                HasSubstr("has a vote for trial 3 already"));
    EXPECT_EQ(store->votes()->front().chosen, Choice::Left);
    EXPECT_THAT(*store->verify(), IsEmpty());
}

TEST_F(SqliteStore, FinishesNoSittingWithOpenTrials) {
    const auto store = begun();
    ASSERT_TRUE(store->append_shown(p1_, shown(4)));
    ASSERT_TRUE(store->append_vote(p1_, vote(4, Choice::Left)));
    EXPECT_THAT(store->finish_sitting(p1_, "2026-03-01T09:10:00.000Z").error(),
                HasSubstr("2 main trial(s) have no vote, the first is number 3"));
}

TEST_F(SqliteStore, FinishesASittingWhoseMissingVotesAreOnRecordAndTakesNoneForThem) {
    const auto store = begun();
    for (const int trial : {3, 4, 5})
        ASSERT_TRUE(store->append_shown(p1_, shown(trial)));
    for (const int trial : {3, 5})
        ASSERT_TRUE(store->append_vote(p1_, vote(trial, Choice::Left)));
    EXPECT_THAT(store->finish_sitting(p1_, "").error(), HasSubstr("1 main trial(s) have no vote"));
    ASSERT_TRUE(store->append_event(p1_, {std::string(missing_vote), "4", 0, ""}));
    EXPECT_THAT(store->append_vote(p1_, vote(4, Choice::Left)).error(),
                HasSubstr("has trial 4 on record as missing"));
    ASSERT_TRUE(store->finish_sitting(p1_, ""));
    EXPECT_THAT(store->votes()->size(), 2u);
    EXPECT_THAT(*store->verify(), IsEmpty());
}

TEST_F(SqliteStore, LetsEverySecondObserverMirrorTheOneBefore) {
    const auto store = open();
    const auto partner = [&](const std::string& observer,
                             ObserverKind kind = ObserverKind::Person) {
        const auto found = store->partner({observer}, kind);
        EXPECT_TRUE(found) << found.error();
        return *found ? (*found)->value : "nobody";
    };
    const auto join = [&](const std::string& observer, ObserverKind kind = ObserverKind::Person) {
        ASSERT_TRUE(store->add_observer({observer}, ""));
        ASSERT_TRUE(store->take_place({observer}, kind, ""));
        ASSERT_TRUE(store->take_place({observer}, kind, "")); // changes nothing
    };
    EXPECT_EQ(partner("A"), "nobody");
    for (const auto* observer : {"A", "B", "C"})
        join(observer);
    join("S1", ObserverKind::Simulated);
    EXPECT_EQ(partner("A"), "nobody");
    EXPECT_EQ(partner("B"), "A");
    EXPECT_EQ(partner("C"), "nobody");
    EXPECT_EQ(partner("D"), "C"); // if D joined now
    EXPECT_EQ(partner("S1"), "nobody");
    EXPECT_EQ(partner("S2", ObserverKind::Simulated), "S1");
    EXPECT_THAT(*store->answers({"B"}), IsEmpty()); // a place is no answer
    // Who leaves makes room for whoever comes next.
    ASSERT_TRUE(store->withdraw({"A"}, "", "wish"));
    EXPECT_EQ(partner("B"), "nobody");
    join("E");
    EXPECT_EQ(partner("B"), "E");
    EXPECT_EQ(partner("D"), "C");
    EXPECT_THAT(store->take_place({"X"}, ObserverKind::Person, "").error(),
                HasSubstr("knows no observer X"));
    EXPECT_THAT(*store->verify(), IsEmpty());
}

// As in a store from before there were places: who has begun alone goes on alone.
TEST_F(SqliteStore, GivesNoPlaceToWhomHasBegunWithoutOne) {
    const auto store = begun();
    ASSERT_TRUE(store->take_place({"P1"}, ObserverKind::Person, ""));
    EXPECT_EQ(*store->partner({"P1"}, ObserverKind::Person), std::nullopt);
    ASSERT_TRUE(store->add_observer({"P2"}, ""));
    ASSERT_TRUE(store->take_place({"P2"}, ObserverKind::Person, ""));
    EXPECT_EQ(*store->partner({"P3"}, ObserverKind::Person), protocols::ObserverId{"P2"});
}

TEST_F(SqliteStore, VerifiesWhatItWrote) {
    EXPECT_THAT(*finished()->verify(), IsEmpty());
}

TEST_F(SqliteStore, TwoProgramsMayTakeTurns) {
    const auto one = begun();
    const auto other = open();
    ASSERT_TRUE(other->add_observer({"P2"}, "2026-03-01T08:59:00.000Z"));
    ASSERT_TRUE(one->append_shown(p1_, shown(3)));
    ASSERT_TRUE(other->begin_sitting(tests::start_of(sitting_of("P2")), tests::small_plan()));
    ASSERT_TRUE(one->append_vote(p1_, vote(3, Choice::Left)));
    EXPECT_THAT(*other->verify(), IsEmpty());
}

} // namespace
