#include "experiment/tables.h"

namespace {

using namespace experiment;

TEST(CsvRow, QuotesOnlyWhatHasToBe) {
    EXPECT_EQ(csv_row({"plain", "a,b", "he said \"no\""}),
              "plain,\"a,b\",\"he said \"\"no\"\"\"\n");
}

TEST(ScheduleTable, HasTheFormScriptsRelyOn) {
    protocols::Schedule schedule;
    schedule.trials = {{1, protocols::Phase::Training, {{"bunny"}, {"back"}, {"a"}, {"b"}}},
                       {2, protocols::Phase::WarmUp, {{"bunny"}, {""}, {"b"}, {"a"}}},
                       {3, protocols::Phase::Main, {{"horse"}, {"left"}, {"a"}, {"b"}}}};
    EXPECT_EQ(schedule_csv(schedule), "trial,phase,scene,variant,left,right\n"
                                      "1,training,bunny,back,a,b\n"
                                      "2,warmup,bunny,,b,a\n"
                                      "3,main,horse,left,a,b\n");
}

} // namespace
