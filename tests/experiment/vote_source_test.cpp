#include "experiment/vote_source.h"

namespace {

using namespace experiment;

store::VoteRow vote(bool simulated) {
    return {.study = "s",
            .observer = {"P1"},
            .session = 1,
            .trial = 8,
            .pair = {{"bunny"}, {"back"}, {"a"}, {"b"}},
            .chosen = protocols::Choice::Right,
            .response_time = std::chrono::milliseconds(1234),
            .onset_utc = "2026-03-01T09:00:00.123Z",
            .simulated = simulated};
}

TEST(LongTable, HasTheFormScriptsRelyOn) {
    EXPECT_EQ(long_csv({vote(false)}),
              "study,observer,session,trial,scene,variant,left,right,chosen,rt_ms,onset_utc\n"
              "s,P1,1,8,bunny,back,a,b,right,1234,2026-03-01T09:00:00.123Z\n");
}

TEST(LongTable, SaysOfEveryVoteWhetherItIsSimulatedAsSoonAsOneIs) {
    EXPECT_EQ(
        long_csv({vote(false), vote(true)}),
        "study,observer,session,trial,scene,variant,left,right,chosen,rt_ms,onset_utc,simulated\n"
        "s,P1,1,8,bunny,back,a,b,right,1234,2026-03-01T09:00:00.123Z,0\n"
        "s,P1,1,8,bunny,back,a,b,right,1234,2026-03-01T09:00:00.123Z,1\n");
}

} // namespace
