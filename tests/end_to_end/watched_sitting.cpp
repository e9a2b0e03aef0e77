#include "tests/end_to_end/watched_sitting.h"

#include "experiment/store/sqlite_store.h"

#include <algorithm>

namespace tests {

namespace store = experiment::store;

RunningProgram WatchedSitting::sitting(const std::string& err) const {
    return RunningProgram({PAIRLIGHT_PROGRAM, "session", study.path().string(), "--observer", "P1",
                           "--window", "640x400"},
                          study / err);
}

std::optional<store::Sitting> WatchedSitting::record() const {
    const auto opened = store::open_votes(study / "votes.sqlite");
    if (!opened)
        return std::nullopt;
    const auto sitting = (*opened)->sitting({{"P1"}, 1});
    return sitting ? *sitting : std::nullopt;
}

std::size_t WatchedSitting::votes() const {
    const auto sitting = record();
    return sitting ? sitting->votes.size() : 0;
}

bool WatchedSitting::has_event(const std::string& kind) const {
    const auto sitting = record();
    return sitting && std::ranges::find(sitting->events, kind, &store::SittingEvent::kind) !=
                          sitting->events.end();
}

void WatchedSitting::expect_whole_sitting() const {
    const auto sitting = record();
    ASSERT_TRUE(sitting.has_value());
    EXPECT_TRUE(sitting->finished_utc.has_value());
    ASSERT_EQ(sitting->votes.size(), static_cast<std::size_t>(pairs_asked));
    for (const auto& planned : sitting->plan)
        EXPECT_EQ(std::ranges::count(sitting->votes, planned.number, &store::MainVote::trial),
                  planned.phase == protocols::Phase::Main ? 1 : 0);
    EXPECT_EQ(pairlight({"verify", study.path().string()}).status, 0);
}

} // namespace tests
