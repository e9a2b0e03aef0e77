#include "experiment/session/conduct.h"
#include "experiment/session/observers.h"
#include "experiment/session/simulated_screen.h"
#include "experiment/store/sqlite_store.h"
#include "tests/experiment/session/failing_store.h"
#include "tests/experiment/store/small_sitting.h"
#include "tests/experiment/store/temporary_folder.h"

namespace {

using namespace experiment;
using namespace experiment::session;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const WallTime morning =
    std::chrono::sys_days(std::chrono::year(2026) / 3 / 1) + std::chrono::hours(12);

SittingRequest request_of(const std::string& observer, int session = 1) {
    SittingRequest request;
    request.study.id = tests::study.id;
    request.study.question = "Which is more realistic?";
    for (const auto* id : {"shss", "green", "phong"})
        request.study.conditions.push_back({{id}, id, protocols::OwnImages{}, 0});
    request.study_sha256 = tests::study.file_sha256;
    request.key = tests::sitting_of(observer, session);
    request.schedule = {tests::small_plan(), "pcg64", "01", "02", 0, "kept"};
    request.instructions = "Welcome\n---\nHow to answer";
    request.renderer = "llvmpipe";
    return request;
}

class Conduct : public testing::Test {
  protected:
    SittingRequest simulated(const std::string& observer, int session = 1) {
        auto request = request_of(observer, session);
        request.simulation = text_of(observer_);
        return request;
    }

    Expected<SittingOutcome> simulate(const SittingRequest& request, store::VoteStore& store) {
        VirtualClock clock(morning);
        SimulatedScreen screen(observer_, request.study.id, request.key.observer,
                               request.key.session, clock);
        return conduct(request, store, screen, clock);
    }

    std::unique_ptr<store::VoteStore> open(const std::string& name = "votes.sqlite") {
        auto opened = store::open_or_create_votes(folder_.path() / name, tests::study);
        EXPECT_TRUE(opened) << opened.error();
        return std::move(*opened);
    }

    tests::TemporaryFolder folder_;
    SimulatedObserver observer_ =
        *parse_simulated_observer("noise=1;seed=5", request_of("S").study);
};

// A screen at which somebody stops (or the power fails) while a trial is shown.
class InterruptedScreen final : public Screen {
  public:
    InterruptedScreen(Screen& screen, VirtualClock& clock, int trial, bool power_fails)
        : screen_(screen), clock_(clock), trial_(trial), power_fails_(power_fails) {}

    DisplayFacts facts() const override { return screen_.facts(); }

    void prepare(const PairView& pair) override { screen_.prepare(pair); }

    Expected<Input> show(const View& view) override {
        if (const auto* pair = std::get_if<PairView>(&view))
            stopping_ = pair->number == trial_;
        if (stopping_ && power_fails_)
            return tl::unexpected(std::string("the power failed"));
        return screen_.show(view);
    }

    std::optional<Input> wait(std::optional<Monotonic> until) override {
        if (!stopping_)
            return screen_.wait(until);
        clock_.advance(std::chrono::seconds(1));
        return Input{clock_.now(), Pressed{Key::Escape}};
    }

  private:
    Screen& screen_;
    VirtualClock& clock_;
    int trial_;
    bool power_fails_;
    bool stopping_ = false;
};

TEST_F(Conduct, TakesASimulatedObserverThroughAWholeSitting) {
    const auto store = open();
    const auto outcome = simulate(simulated("S1"), *store);
    ASSERT_TRUE(outcome) << outcome.error();
    EXPECT_TRUE(outcome->finished);
    EXPECT_FALSE(outcome->resumed);
    EXPECT_EQ(outcome->votes, 3);

    const auto sitting = **store->sitting(tests::sitting_of("S1"));
    EXPECT_EQ(sitting.start.started_utc, "2026-03-01T12:00:00.000Z");
    EXPECT_EQ(sitting.start.simulation, text_of(observer_));
    EXPECT_TRUE(sitting.finished_utc.has_value());
    ASSERT_THAT(sitting.shown, SizeIs(5));
    ASSERT_THAT(sitting.votes, SizeIs(3));
    for (const auto& vote : sitting.votes) {
        const auto& planned = sitting.plan[static_cast<std::size_t>(vote.trial - 1)];
        const auto expected = answer(observer_, "glow", {"S1"}, 1, vote.trial, planned.trial);
        EXPECT_EQ(vote.chosen == protocols::Choice::Left, expected.side == protocols::Side::Left);
        EXPECT_EQ(vote.key_ns - vote.onset_ns, expected.response_time.count());
        EXPECT_EQ(vote.device, "simulated");
    }
    // Two pages of 15 s, 500 ms of grey: the training pair appears after 30.5 s of virtual time.
    EXPECT_EQ(sitting.shown[0].onset_utc, "2026-03-01T12:00:30.500Z");
    EXPECT_EQ(sitting.shown[0].onset_source, "virtual");
    EXPECT_EQ(sitting.shown[0].extra_ns, 0);
    EXPECT_THAT(*store->verify(), IsEmpty());
    const auto votes = *store->votes();
    ASSERT_THAT(votes, SizeIs(3));
    for (const auto& row : votes)
        EXPECT_TRUE(row.simulated);
}

TEST_F(Conduct, DoesNotRepeatAFinishedSitting) {
    const auto store = open();
    ASSERT_TRUE(simulate(simulated("S1"), *store));
    const auto votes = *store->votes();
    EXPECT_THAT(simulate(simulated("S1"), *store).error(),
                HasSubstr("session 1 of observer S1 is finished"));
    EXPECT_EQ(*store->votes(), votes);
    EXPECT_THAT(*store->verify(), IsEmpty());
}

TEST_F(Conduct, GoesOnWithASittingThatWasStoppedOrBroken) {
    const auto whole = open("whole.sqlite");
    ASSERT_TRUE(simulate(simulated("S1"), *whole));
    for (const bool power_fails : {false, true})
        for (int trial = 1; trial <= 5; ++trial) {
            const auto name = std::to_string(trial) + (power_fails ? "broken" : "stopped");
            const auto request = simulated("S1");
            {
                const auto store = open(name);
                VirtualClock clock(morning);
                SimulatedScreen within(observer_, "glow", {"S1"}, 1, clock);
                InterruptedScreen screen(within, clock, trial, power_fails);
                const auto outcome = conduct(request, *store, screen, clock);
                EXPECT_EQ(outcome.has_value(), !power_fails);
                EXPECT_TRUE(power_fails || !outcome->finished);
                EXPECT_THAT(*store->votes(), SizeIs(std::max(0, trial - 3))) << name;
            }
            const auto store = open(name);
            const auto outcome = simulate(request, *store);
            ASSERT_TRUE(outcome) << outcome.error();
            EXPECT_TRUE(outcome->resumed && outcome->finished);
            const auto votes = *store->votes();
            const auto expected = *whole->votes();
            ASSERT_EQ(votes.size(), expected.size()) << name;
            for (std::size_t i = 0; i < votes.size(); ++i) {
                EXPECT_EQ(votes[i].pair, expected[i].pair);
                EXPECT_EQ(votes[i].chosen, expected[i].chosen);
                EXPECT_EQ(votes[i].response_time, expected[i].response_time);
            }
            EXPECT_THAT(*store->verify(), IsEmpty());
        }
}

TEST_F(Conduct, NeverGoesOnAsAPersonWhereASimulationStopped) {
    const auto store = open();
    VirtualClock clock(morning);
    SimulatedScreen within(observer_, "glow", {"S1"}, 1, clock);
    InterruptedScreen screen(within, clock, 4, false);
    ASSERT_TRUE(conduct(simulated("S1"), *store, screen, clock));
    EXPECT_THAT(conduct(request_of("S1"), *store, screen, clock).error(),
                HasSubstr("was begun as simulated (scores="));
}

TEST_F(Conduct, GoesOnWithTheSamePlanOnly) {
    const auto store = open();
    VirtualClock clock(morning);
    SimulatedScreen within(observer_, "glow", {"S1"}, 1, clock);
    InterruptedScreen screen(within, clock, 4, false);
    auto request = simulated("S1");
    ASSERT_TRUE(conduct(request, *store, screen, clock));
    std::swap(request.schedule.trials[3].trial, request.schedule.trials[4].trial);
    EXPECT_THAT(simulate(request, *store).error(), HasSubstr("with another plan"));
}

// Whose sides an observer mirrors may change when somebody leaves; the plan that was begun stands.
TEST_F(Conduct, GoesOnWithTheSidesItBeganWith) {
    const auto store = open();
    VirtualClock clock(morning);
    SimulatedScreen within(observer_, "glow", {"S1"}, 1, clock);
    InterruptedScreen screen(within, clock, 4, false);
    auto request = simulated("S1");
    const auto begun = request.schedule.trials;
    ASSERT_TRUE(conduct(request, *store, screen, clock));
    for (auto& planned : request.schedule.trials)
        std::swap(planned.trial.left, planned.trial.right);
    ASSERT_TRUE(simulate(request, *store));
    const auto votes = *store->votes();
    ASSERT_THAT(votes, SizeIs(3));
    for (const auto& vote : votes)
        EXPECT_EQ(vote.pair, begun[static_cast<std::size_t>(vote.trial - 1)].trial);
    EXPECT_THAT(*store->verify(), IsEmpty());
}

TEST_F(Conduct, KeepsSittingsOfAPersonDaysApart) {
    const auto store = open();
    ASSERT_TRUE(store->add_observer({"P1"}, "2026-03-01T08:59:00.000Z"));
    auto start = tests::start_of(tests::sitting_of("P1"));
    start.local_date = local_date(morning);
    ASSERT_TRUE(store->begin_sitting(start, tests::small_plan()));
    auto second = request_of("P1", 2);
    EXPECT_THAT(check_sitting(second, *store, VirtualClock(morning)).error(),
                HasSubstr("expected at least 1 day(s) between them"));
    EXPECT_TRUE(check_sitting(second, *store, VirtualClock(morning + std::chrono::hours(24))));
    EXPECT_TRUE(check_sitting(request_of("P2", 1), *store, VirtualClock(morning)));
    second.override_reason = "leaves the country tomorrow";
    EXPECT_TRUE(check_sitting(second, *store, VirtualClock(morning)));
}

TEST_F(Conduct, WantsInstructions) {
    auto request = simulated("S1");
    request.instructions = "\n---\n";
    const auto store = open();
    EXPECT_THAT(simulate(request, *store).error(), HasSubstr("instructions.md: is empty"));
    EXPECT_THAT(*store->sittings(), IsEmpty());
}

TEST_F(Conduct, LosesAndInventsNoVoteWhereverThePowerFails) {
    const auto whole = open("whole.sqlite");
    tests::FailingStore counting(*whole, 1000);
    ASSERT_TRUE(simulate(simulated("S1"), counting));
    ASSERT_GE(counting.writes(), 19); // every kind of row there is in a sitting
    const auto expected = *whole->votes();
    for (int good = 0; good < counting.writes(); ++good) {
        const auto name = "cut" + std::to_string(good);
        const auto store = open(name);
        tests::FailingStore failing(*store, good);
        EXPECT_EQ(simulate(simulated("S1"), failing).error(), "the disk is full");
        const auto kept = *store->votes();
        // Nothing is shown after a vote that could not be stored.
        if (const auto sitting = *store->sitting(tests::sitting_of("S1")))
            for (const auto& shown : sitting->shown)
                if (shown.trial > 3) {
                    EXPECT_GE(static_cast<int>(kept.size()), shown.trial - 3) << name;
                }
        ASSERT_TRUE(simulate(simulated("S1"), *store)) << name;
        const auto votes = *store->votes();
        ASSERT_EQ(votes.size(), expected.size()) << name;
        for (std::size_t i = 0; i < votes.size(); ++i) {
            EXPECT_EQ(votes[i].pair, expected[i].pair) << name;
            EXPECT_EQ(votes[i].chosen, expected[i].chosen) << name;
        }
        EXPECT_THAT(*store->verify(), IsEmpty()) << name;
    }
}

TEST_F(Conduct, RefusesADayThatIsBeforeAnEarlierSitting) {
    const auto store = open();
    ASSERT_TRUE(store->add_observer({"P1"}, "2026-03-01T08:59:00.000Z"));
    auto start = tests::start_of(tests::sitting_of("P1"));
    start.local_date = local_date(morning);
    ASSERT_TRUE(store->begin_sitting(start, tests::small_plan()));
    const VirtualClock set_back(morning - std::chrono::hours(48));
    EXPECT_THAT(check_sitting(request_of("P1", 2), *store, set_back).error(),
                HasSubstr("expected at least 1 day(s) between them"));
}

// A machine whose wall clock is set back an hour in the middle of a sitting.
class ClockSetBack final : public Clock {
  public:
    ClockSetBack(const VirtualClock& within, Monotonic when) : within_(within), when_(when) {}

    Monotonic now() const override { return within_.now(); }

    WallTime wall() const override {
        return within_.wall() - (now() >= when_ ? std::chrono::hours(1) : std::chrono::hours(0));
    }

  private:
    const VirtualClock& within_;
    Monotonic when_;
};

TEST_F(Conduct, IsNotMovedByAClockThatIsSetBack) {
    const auto expected = open("whole.sqlite");
    ASSERT_TRUE(simulate(simulated("S1"), *expected));
    const auto store = open();
    VirtualClock within(morning);
    const ClockSetBack clock(within, std::chrono::seconds(100)); // in the adaptation
    SimulatedScreen screen(observer_, "glow", {"S1"}, 1, within);
    ASSERT_TRUE(conduct(simulated("S1"), *store, screen, clock));
    const auto votes = *store->votes();
    const auto others = *expected->votes();
    ASSERT_EQ(votes.size(), others.size());
    for (std::size_t i = 0; i < votes.size(); ++i) {
        EXPECT_EQ(votes[i].chosen, others[i].chosen);
        EXPECT_EQ(votes[i].response_time, others[i].response_time);
    }
    EXPECT_LT(votes.back().onset_utc, others.back().onset_utc);
    EXPECT_THAT(*store->verify(), IsEmpty());
}

TEST_F(Conduct, TakesNobodyWhoHasNotConsentedOrWasNotAsked) {
    const auto store = open();
    auto request = request_of("P1");
    request.study.panel.consent = true;
    request.study.panel.questions = protocols::standard_questions();
    const VirtualClock clock(morning);
    EXPECT_THAT(check_sitting(request, *store, clock).error(), HasSubstr("no consent on record"));
    ASSERT_TRUE(store->add_observer({"P1"}, "2026-03-01T08:59:00.000Z"));
    std::vector<store::Answer> answers{{"consent", "yes", ""}};
    for (const auto& question : request.study.panel.questions)
        answers.push_back({question.id, "yes", ""});
    ASSERT_TRUE(store->append_answers({"P1"}, std::span(answers).first(3)));
    EXPECT_THAT(check_sitting(request, *store, clock).error(),
                HasSubstr("no answer to 'glasses' on record"));
    ASSERT_TRUE(store->append_answers({"P1"}, answers));
    EXPECT_TRUE(check_sitting(request, *store, clock));
    EXPECT_TRUE(check_sitting(simulated("S1"), *store, clock));
}

TEST_F(Conduct, KeepsTheTimesOfEveryFrameAndAGrade) {
    const auto store = open();
    ASSERT_TRUE(simulate(simulated("S1"), *store));
    const auto sitting = **store->sitting(tests::sitting_of("S1"));
    for (std::size_t i = 0; i < sitting.votes.size(); ++i) {
        std::vector<std::string> names;
        for (const auto& frame : sitting.votes[i].frames)
            names.push_back(frame.what);
        if (i == 0)
            EXPECT_THAT(names, ElementsAre("grey", "pair"));
        else
            EXPECT_THAT(names, ElementsAre("stored", "grey", "pair"));
        EXPECT_EQ(sitting.votes[i].frames.back().done_ns, sitting.votes[i].onset_ns);
    }
    EXPECT_THAT(sitting.frames, SizeIs(2)); // of the training and the warm-up
    const auto timing = std::ranges::find(sitting.events, "timing", &store::SittingEvent::kind);
    ASSERT_NE(timing, sitting.events.end());
    EXPECT_EQ(timing->detail, "grade=U; frames=10; late=0; refreshes_missed=0");
}

TEST_F(Conduct, TellsTheExperimenterHowFarItIs) {
    const auto store = open();
    std::vector<std::string> told;
    auto request = simulated("S1");
    request.watch = [&](const Standing& standing) {
        const auto text = standing.doing + " " + std::to_string(standing.answered) + "/" +
                          std::to_string(standing.main);
        if (told.empty() || told.back() != text)
            told.push_back(text);
    };
    ASSERT_TRUE(simulate(request, *store));
    EXPECT_THAT(told,
                ElementsAre("instructions 1 of 2 0/3", "instructions 2 of 2 0/3", "training 0/3",
                            "questions 0/3", "adaptation 0/3", "main trials 0/3", "main trials 1/3",
                            "main trials 2/3", "thanks 3/3"));
}

TEST_F(Conduct, KeepsGradesBesideVotes) {
    const auto store = open();
    auto request = simulated("S1");
    request.study.plan.response = protocols::Response::SevenGrades;
    VirtualClock clock(morning);
    SimulatedScreen screen(observer_, "glow", {"S1"}, 1, clock, protocols::Response::SevenGrades);
    ASSERT_TRUE(conduct(request, *store, screen, clock));
    const auto votes = *store->votes();
    ASSERT_THAT(votes, SizeIs(3));
    for (const auto& row : votes) {
        ASSERT_TRUE(row.grade.has_value());
        EXPECT_EQ(row.chosen, *row.grade < 0   ? protocols::Choice::Left
                              : *row.grade > 0 ? protocols::Choice::Right
                                               : protocols::Choice::Tie);
    }
}

TEST_F(Conduct, ShowsPicturesInTurnAndTakesAnswersAfterTheSecond) {
    for (const auto way : {protocols::Presentation::Sequential, protocols::Presentation::Flip}) {
        const auto store = open(way == protocols::Presentation::Flip ? "flip" : "sequential");
        auto request = simulated("S1");
        request.study.plan.presentation = way;
        request.study.plan.view_ms = way == protocols::Presentation::Flip ? 0 : 300;
        ASSERT_TRUE(simulate(request, *store));
        const auto sitting = **store->sitting(tests::sitting_of("S1"));
        ASSERT_THAT(sitting.votes, SizeIs(3));
        for (const auto& vote : sitting.votes) {
            std::vector<std::string> names;
            for (const auto& frame : vote.frames)
                if (frame.what != "stored")
                    names.push_back(frame.what);
            if (way == protocols::Presentation::Flip)
                EXPECT_THAT(names, ElementsAre("grey", "first", "second"));
            else
                EXPECT_THAT(names, ElementsAre("grey", "first", "between", "second", "hidden"));
            const auto& planned = sitting.plan[static_cast<std::size_t>(vote.trial - 1)];
            const auto expected = answer(observer_, "glow", {"S1"}, 1, vote.trial, planned.trial);
            EXPECT_EQ(vote.key_ns - vote.onset_ns, expected.response_time.count());
        }
    }
}

} // namespace
