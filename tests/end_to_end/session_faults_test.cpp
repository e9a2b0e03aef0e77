// What happens to a sitting in the real window, and that no vote is lost or invented by it.
#include "experiment/store/sqlite_store.h"
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"
#include "tests/end_to_end/virtual_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace {

using namespace tests;
using testing::HasSubstr;
namespace store = experiment::store;

class SessionFaults : public testing::Test {
  protected:
    void SetUp() override { write_small_study(study.path()); }

    RunningProgram sitting(const std::string& err = "stderr") {
        return RunningProgram({PAIRLIGHT_PROGRAM, "session", study.path().string(), "--observer",
                               "P1", "--window", "640x400"},
                              study / err);
    }

    std::optional<store::Sitting> record() const {
        const auto opened = store::open_votes(study / "votes.sqlite");
        if (!opened)
            return std::nullopt;
        const auto sitting = (*opened)->sitting({{"P1"}, 1});
        return sitting ? *sitting : std::nullopt;
    }

    std::size_t votes() const {
        const auto sitting = record();
        return sitting ? sitting->votes.size() : 0;
    }

    bool has_event(const std::string& kind) const {
        const auto sitting = record();
        return sitting && std::ranges::find(sitting->events, kind, &store::SittingEvent::kind) !=
                              sitting->events.end();
    }

    /// Presses what a sitting waits for until `done`, two minutes at most.
    template <class Done>
    bool press_on(RunningProgram& program, Done done) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
        while (program.is_running() && !done() && std::chrono::steady_clock::now() < end)
            for (const auto* key : {"space", "F9", "Left"})
                screen.press(key);
        return done() || !program.is_running();
    }

    void expect_whole_sitting() const {
        const auto sitting = record();
        ASSERT_TRUE(sitting.has_value());
        EXPECT_TRUE(sitting->finished_utc.has_value());
        EXPECT_EQ(sitting->votes.size(), static_cast<std::size_t>(pairs_asked));
        EXPECT_EQ(pairlight({"verify", study.path().string()}).status, 0);
    }

    VirtualScreen screen{800, 600};
    TemporaryFolder study;
};

TEST_F(SessionFaults, ASecondProgramOnTheSameSittingIsRefused) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 1; }));
    const auto second =
        pairlight({"session", study.path().string(), "--observer", "P1", "--window", "640x400"});
    EXPECT_NE(second.status, 0);
    EXPECT_THAT(second.err, HasSubstr("is taking place in another program"));
    ASSERT_TRUE(press_on(program, [] { return false; }));
    expect_whole_sitting();
}

TEST_F(SessionFaults, AWindowResizedInMidTrialPausesTheSitting) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 1; }));
    run({"xdotool", "search", "--name", "Pairlight session", "windowsize", "700", "500"});
    ASSERT_TRUE(press_on(program, [] { return false; }));
    EXPECT_EQ(program.status(), 0) << read_file(study / "stderr");
    EXPECT_TRUE(has_event("display_changed"));
    expect_whole_sitting();
}

TEST_F(SessionFaults, AWindowTooSmallForThePicturesEndsTheSittingAndKeepsItsVotes) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 2; }));
    run({"xdotool", "search", "--name", "Pairlight session", "windowsize", "300", "200"});
    ASSERT_TRUE(press_on(program, [] { return false; }));
    EXPECT_EQ(program.status(), 1);
    EXPECT_THAT(read_file(study / "stderr"), HasSubstr("pictures are never scaled"));
    const auto before = votes();
    EXPECT_GE(before, 2u);
    EXPECT_LT(before, static_cast<std::size_t>(pairs_asked));
    auto again = sitting("stderr2");
    ASSERT_TRUE(press_on(again, [] { return false; }));
    expect_whole_sitting();
}

TEST_F(SessionFaults, AStimulusThatChangesEndsTheSittingAndKeepsItsVotes) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 1; }));
    const auto file = study / "stimuli/garden/first.png";
    const auto whole = read_file(file);
    for (const auto* scene : {"garden", "harbour"})
        for (const auto* condition : {"first", "second", "third"}) {
            const auto path = study / fmt::format("stimuli/{}/{}.png", scene, condition);
            write_file(path, read_file(path) + "x");
        }
    ASSERT_TRUE(press_on(program, [] { return false; }));
    EXPECT_EQ(program.status(), 1);
    EXPECT_THAT(read_file(study / "stderr"), HasSubstr("was changed while the sitting took place"));
    EXPECT_LT(votes(), static_cast<std::size_t>(pairs_asked));
    EXPECT_GE(votes(), 1u);
    EXPECT_EQ(pairlight({"verify", study.path().string()}).status, 0);
    write_small_study(study.path());
    auto again = sitting("stderr2");
    ASSERT_TRUE(press_on(again, [] { return false; }));
    expect_whole_sitting();
}

TEST_F(SessionFaults, AWindowTornDownFromOutsideTakesNoVoteWithIt) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 1; }));
    const auto before = votes();
    run({"xdotool", "search", "--name", "Pairlight session", "windowclose"});
    ASSERT_TRUE(press_on(program, [] { return false; }));
    EXPECT_GE(votes(), before);
    EXPECT_EQ(pairlight({"verify", study.path().string()}).status, 0);
    auto again = sitting("stderr2");
    ASSERT_TRUE(press_on(again, [] { return false; }));
    expect_whole_sitting();
}

TEST_F(SessionFaults, EverySittingHasItsStimuliAndItsTimingOnRecord) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [] { return false; }));
    expect_whole_sitting();
    EXPECT_TRUE(has_event("stimuli"));
    const auto sitting = record();
    const auto timing = std::ranges::find(sitting->events, "timing", &store::SittingEvent::kind);
    ASSERT_NE(timing, sitting->events.end());
    EXPECT_THAT(timing->detail, HasSubstr("grade=U;")); // a virtual display proves nothing
    EXPECT_EQ(sitting->start.timing_grade, "U");
    EXPECT_THAT(sitting->start.display, HasSubstr("swaps="));
    // The grey lasts as long as the study says, however long the vote took to the disk.
    for (const auto& vote : sitting->votes) {
        const auto& frames = vote.frames;
        ASSERT_GE(frames.size(), 2u);
        const auto& pair = frames[frames.size() - 1];
        const auto& grey = frames[frames.size() - 2];
        EXPECT_EQ(grey.what, "grey");
        EXPECT_GE(pair.done_ns - grey.done_ns, 100'000'000);
        if (frames.size() > 2) {
            EXPECT_EQ(frames[0].what, "stored");
            EXPECT_LT(frames[0].done_ns, pair.done_ns) << "a pair before its predecessor's vote";
        }
    }
}

} // namespace
