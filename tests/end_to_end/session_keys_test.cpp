// Keys as people press them: held, together, at known times.
#include "tests/end_to_end/watched_sitting.h"

#include <algorithm>
#include <thread>

namespace {

using namespace tests;
using namespace std::chrono_literals;

using SessionKeys = WatchedSitting;

TEST_F(SessionKeys, ThatAreHeldAnswerOnePairAndNoMore) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 1; }));
    run({"xdotool", "keydown", "Right"});
    std::this_thread::sleep_for(
        3s); // five pairs could be answered in it, and dozens of repetitions
    const auto held = record();
    run({"xdotool", "keyup", "Right"});
    ASSERT_TRUE(held.has_value());
    EXPECT_LE(std::ranges::count(held->votes, "right", &experiment::store::MainVote::key_name), 1);
    EXPECT_TRUE(program.is_running());
    ASSERT_TRUE(press_to_the_end(program));
    expect_whole_sitting();
}

TEST_F(SessionKeys, ThatComeBothAtOnceAreNoAnswer) {
    auto program = sitting();
    ASSERT_TRUE(press_on(program, [&] { return votes() >= 1; }));
    Typist typist;
    const auto end = std::chrono::steady_clock::now() + 60s;
    while (!has_event("ambiguous") && std::chrono::steady_clock::now() < end) {
        const auto before = votes();
        typist.press("Left");
        typist.press("Right"); // within a millisecond of each other
        std::this_thread::sleep_for(200ms);
        EXPECT_EQ(votes(), before);
    }
    EXPECT_TRUE(has_event("ambiguous"));
    ASSERT_TRUE(press_to_the_end(program));
    expect_whole_sitting();
}

} // namespace
