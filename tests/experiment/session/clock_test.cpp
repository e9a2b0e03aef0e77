#include "experiment/session/clock.h"

namespace {

using namespace experiment::session;

TEST(Clock, WritesUtcWithMilliseconds) {
    using namespace std::chrono;
    EXPECT_EQ(utc_text(sys_days(2026y / 3 / 1) + 9h + 5min + 7s + 42ms),
              "2026-03-01T09:05:07.042Z");
    EXPECT_EQ(utc_text(sys_days(1970y / 1 / 1)), "1970-01-01T00:00:00.000Z");
}

TEST(Clock, OfAMachineGoesForward) {
    const SystemClock clock;
    const auto before = clock.now();
    EXPECT_GE(clock.now(), before);
}

TEST(Clock, ThatIsVirtualGoesWhenTold) {
    using namespace std::chrono;
    const WallTime start = sys_days(2026y / 3 / 1) + 23h;
    VirtualClock clock(start);
    EXPECT_EQ(clock.now(), Monotonic(0));
    clock.advance(2h);
    EXPECT_EQ(clock.now(), Monotonic(2h));
    EXPECT_EQ(utc_text(clock.wall()), "2026-03-02T01:00:00.000Z");
}

TEST(Dates, AreCountedInCalendarDays) {
    EXPECT_EQ(days_between("2026-02-28", "2026-03-01"), 1);
    EXPECT_EQ(days_between("2028-02-28", "2028-03-01"), 2);
    EXPECT_EQ(days_between("2026-03-01", "2026-03-01"), 0);
    EXPECT_EQ(days_between("2026-03-01", "2025-03-01"), -365);
}

} // namespace
