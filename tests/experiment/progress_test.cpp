#include "experiment/progress.h"

namespace {

using namespace std::chrono_literals;
using experiment::spoken_duration;

TEST(SpokenDuration, IsInSecondsBelowAMinuteAndInBothAbove) {
    EXPECT_EQ(spoken_duration(0s), "0 s");
    EXPECT_EQ(spoken_duration(59s), "59 s");
    EXPECT_EQ(spoken_duration(125s), "2 min 05 s");
}

} // namespace
