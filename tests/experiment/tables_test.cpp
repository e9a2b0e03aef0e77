#include "experiment/tables.h"

namespace {

using namespace experiment;

TEST(CsvField, IsQuotedOnlyWhereItHasToBe) {
    EXPECT_EQ(csv_field("plain"), "plain");
    EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_field("he said \"no\""), "\"he said \"\"no\"\"\"");
    EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
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
