#include "experiment/viewer/frame_times.h"

namespace {

using experiment::viewer::FrameTimes;

TEST(FrameTimes, HaveNoMedianBeforeTheFirst) {
    EXPECT_EQ(FrameTimes{}.median(), std::nullopt);
}

TEST(FrameTimes, HaveTheMiddleOneAsMedianOrTheMeanOfTheTwo) {
    FrameTimes times;
    times.add(0.1, 30);
    times.add(0.2, 10);
    EXPECT_EQ(times.median(), 20);
    times.add(0.3, 500);
    EXPECT_EQ(times.median(), 30);
}

TEST(FrameTimes, ForgetWhatIsOlderThanASecond) {
    FrameTimes times;
    times.add(0, 1000);
    times.add(0.5, 7);
    times.add(1.25, 9);
    EXPECT_EQ(times.median(), 8);
}

} // namespace
