#include "experiment/session/timing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace experiment::session;
using testing::HasSubstr;

std::vector<Monotonic> intervals(int count, double ms) {
    return std::vector<Monotonic>(static_cast<std::size_t>(count),
                                  Monotonic(static_cast<long long>(ms * 1e6)));
}

TEST(SwapTest, TellsADisplayThatKeepsTime) {
    const auto test = judge_swaps(intervals(600, 16.667), 60);
    EXPECT_EQ(test.verdict, SwapVerdict::Synced);
    EXPECT_EQ(test.late, 0);
    EXPECT_NEAR(test.mean_ms, 16.667, 1e-9);
    EXPECT_LE(test.sd_ms, 1e-9);
}

TEST(SwapTest, CountsADroppedFrameAndAStall) {
    auto swaps = intervals(600, 16.667);
    swaps[100] *= 2;
    swaps[200] = std::chrono::milliseconds(300);
    const auto test = judge_swaps(swaps, 60);
    EXPECT_EQ(test.late, 2);
    EXPECT_NE(test.verdict, SwapVerdict::Synced);
    EXPECT_EQ(test.greatest_ms, 300);
}

TEST(SwapTest, NamesAScreenThatDoesNotWaitAndOneThatWaitsTwice) {
    EXPECT_EQ(judge_swaps(intervals(600, 3.3), 60).verdict, SwapVerdict::Unsynced);
    EXPECT_EQ(judge_swaps(intervals(600, 33.333), 60).verdict, SwapVerdict::HalfRate);
    EXPECT_EQ(judge_swaps(intervals(600, 20), 60).verdict, SwapVerdict::Unstable);
    EXPECT_EQ(judge_swaps(intervals(600, 16.667), 0).verdict, SwapVerdict::Unsynced);
    EXPECT_THAT(text_of(judge_swaps(intervals(600, 16.667), 0)), HasSubstr("not reported"));
}

TEST(TimingGrade, OfAVirtualDisplayIsNeverBetterThanUnverified) {
    for (const auto verdict :
         {SwapVerdict::Synced, SwapVerdict::Unsynced, SwapVerdict::HalfRate, SwapVerdict::Unstable})
        EXPECT_EQ(timing_grade({verdict, DisplayKind::Virtual}, 1000, 0), "U");
}

TEST(TimingGrade, DependsOnWaitingSwapsLateFramesAndTheWholeScreen) {
    const DisplayTiming full{SwapVerdict::Synced, DisplayKind::FullScreen};
    EXPECT_EQ(timing_grade(full, 1000, 0), "B");
    EXPECT_EQ(timing_grade(full, 1000, 1), "B");
    EXPECT_EQ(timing_grade(full, 1000, 2), "C");
    EXPECT_EQ(timing_grade(full, 99, 0), "C"); // too few to say
    EXPECT_EQ(timing_grade({SwapVerdict::Synced, DisplayKind::Windowed}, 1000, 0), "C");
    EXPECT_EQ(timing_grade({SwapVerdict::Unsynced, DisplayKind::FullScreen}, 1000, 0), "U");
    EXPECT_EQ(provisional_grade(full), "C");
}

} // namespace
