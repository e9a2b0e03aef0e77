// What happens to a sitting in the real window, and that no vote is lost or invented by it.
#include "experiment/store/sqlite_database.h"
#include "tests/end_to_end/watched_sitting.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace {

using namespace tests;
using testing::HasSubstr;
using namespace std::chrono_literals;
namespace store = experiment::store;

class SessionFaults : public WatchedSitting {
  protected:
    /// Some votes but not all, in a record that is whole; and with the study as it was, the rest.
    void expect_a_whole_part_that_is_finished_later() {
        EXPECT_LT(votes(), static_cast<std::size_t>(pairs_asked));
        EXPECT_GE(votes(), 1u);
        EXPECT_EQ(pairlight({"verify", study.path().string()}).status, 0);
        write_small_study(study.path());
        auto again = sitting("stderr2");
        ASSERT_TRUE(press_to_the_end(again));
        EXPECT_EQ(again.status(), 0) << read_file(study / "stderr2");
        expect_whole_sitting();
    }
};

TEST_F(SessionFaults, ASecondProgramOnTheSameSittingIsRefused) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 1; }));
    const auto second =
        pairlight({"session", study.path().string(), "--observer", "P1", "--window", "640x400"});
    EXPECT_NE(second.status, 0);
    EXPECT_THAT(second.err, HasSubstr("is taking place in another program"));
    ASSERT_TRUE(press_to_the_end(program));
    expect_whole_sitting();
}

TEST_F(SessionFaults, AWindowResizedInMidTrialPausesTheSitting) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 1; }));
    run({"xdotool", "search", "--name", "Pairlight session", "windowsize", "700", "500"});
    ASSERT_TRUE(press_to_the_end(program));
    EXPECT_EQ(program.status(), 0) << read_file(study / "stderr");
    EXPECT_TRUE(has_event("display_changed"));
    expect_whole_sitting();
}

TEST_F(SessionFaults, AWindowTooSmallForThePicturesEndsTheSittingAndKeepsItsVotes) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 2; }));
    run({"xdotool", "search", "--name", "Pairlight session", "windowsize", "300", "200"});
    ASSERT_TRUE(press_to_the_end(program));
    EXPECT_EQ(program.status(), 1);
    EXPECT_THAT(read_file(study / "stderr"), HasSubstr("pictures are never scaled"));
    const auto before = votes();
    EXPECT_GE(before, 2u);
    EXPECT_LT(before, static_cast<std::size_t>(pairs_asked));
    auto again = sitting("stderr2");
    ASSERT_TRUE(press_to_the_end(again));
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
    ASSERT_TRUE(press_to_the_end(program));
    EXPECT_EQ(program.status(), 1);
    EXPECT_THAT(read_file(study / "stderr"), HasSubstr("was changed while the sitting took place"));
    expect_a_whole_part_that_is_finished_later();
}

TEST_F(SessionFaults, AStimulusThatIsGoneEndsTheSittingAndKeepsItsVotes) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 1; }));
    std::filesystem::remove_all(study / "stimuli");
    ASSERT_TRUE(press_to_the_end(program));
    EXPECT_EQ(program.status(), 1);
    EXPECT_THAT(read_file(study / "stderr"), HasSubstr(".png: cannot be read: No such file"));
    expect_a_whole_part_that_is_finished_later();
}

TEST_F(SessionFaults, AStoreThatAnotherProgramHoldsEndsTheSittingAndKeepsItsVotes) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 1; }));
    const auto before = votes();
    {
        store::SqliteDatabase other(study / "votes.sqlite", store::WhenMissing::Fail);
        other.execute("BEGIN IMMEDIATE");
        ASSERT_TRUE(press_to_the_end(program));
    }
    EXPECT_EQ(program.status(), 1);
    EXPECT_THAT(read_file(study / "stderr"), HasSubstr("another program is writing to it"));
    EXPECT_GE(votes(), before);
    EXPECT_LT(votes(), static_cast<std::size_t>(pairs_asked));
    auto again = sitting("stderr2");
    ASSERT_TRUE(press_to_the_end(again));
    EXPECT_EQ(again.status(), 0) << read_file(study / "stderr2");
    expect_whole_sitting();
}

// Ten times, on the pages, in the training, the adaptation and the main trials alike: what counts
// is not where a program dies but what it had written, and every one of those places has a test of
// its own with the power failing (Conduct.LosesAndInventsNoVoteWhereverThePowerFails).
TEST_F(SessionFaults, AProgramKilledAgainAndAgainLosesAndInventsNoVote) {
    std::set<int> answered;
    for (int kill = 0; kill < 10; ++kill) {
        auto program = sitting();
        const auto end = std::chrono::steady_clock::now() + 700ms * (kill + 1);
        ASSERT_TRUE(press_on(program, [&] { return std::chrono::steady_clock::now() >= end; }));
        if (!program.is_running())
            break;
        program.kill_at_once();
        std::set<int> now;
        if (const auto sitting = record())
            for (const auto& vote : sitting->votes) {
                EXPECT_TRUE(now.insert(vote.trial).second) << "trial " << vote.trial << " twice";
            }
        EXPECT_TRUE(std::ranges::includes(now, answered)) << "a vote is gone";
        answered = now;
    }
    auto last = sitting("stderr2");
    ASSERT_TRUE(press_to_the_end(last));
    expect_whole_sitting();
}

TEST_F(SessionFaults, AWindowTornDownFromOutsideTakesNoVoteWithIt) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 1; }));
    const auto before = votes();
    run({"xdotool", "search", "--name", "Pairlight session", "windowclose"});
    ASSERT_TRUE(press_to_the_end(program));
    EXPECT_GE(votes(), before);
    EXPECT_EQ(pairlight({"verify", study.path().string()}).status, 0);
    auto again = sitting("stderr2");
    ASSERT_TRUE(press_to_the_end(again));
    expect_whole_sitting();
}

TEST_F(SessionFaults, EverySittingHasItsStimuliAndItsTimingOnRecord) {
    auto program = sitting();
    ASSERT_TRUE(press_to_the_end(program));
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
