// The real window is a thin shell: a study that is simulated through it leaves the store that the
// state machine alone leaves, but for the clocks.
#include "experiment/store/sqlite_database.h"
#include "experiment/store/sqlite_schema.h"
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"
#include "tests/end_to_end/virtual_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace {

using namespace tests;
using namespace experiment::store;

/// Wall-clock times, the chain over them, and what the pictures were seen on.
bool depends_on_the_day_or_the_display(const std::string& column) {
    return column == "digest" || column == "local_date" || column == "display" ||
           column == "file_sha256" || column == "study_sha256" || column.ends_with("utc");
}

/// Every row of every table, without those columns.  Monotonic times are virtual, and stay.
std::map<std::string, std::vector<Row>> contents(const std::filesystem::path& file) {
    const SqliteDatabase database(file, WhenMissing::Fail);
    std::map<std::string, std::vector<Row>> tables;
    for (const auto& table : chained_tables()) {
        std::string columns;
        for (const auto& column : database.query(fmt::format("PRAGMA table_info({})", table)))
            if (const auto& name = text_of(column[1]); !depends_on_the_day_or_the_display(name))
                columns += (columns.empty() ? "" : ", ") + name;
        tables[table] =
            database.query(fmt::format("SELECT {} FROM {} ORDER BY seq", columns, table));
    }
    return tables;
}

/// Both ways, and the two stores beside each other.
void expect_same_stores(const std::filesystem::path& study, int observers, const char* window) {
    const auto simulate = [&](std::vector<std::string> how) {
        std::vector<std::string> command{"simulate", study.string(), "--observers",
                                         std::to_string(observers), "--quiet"};
        command.insert(command.end(), how.begin(), how.end());
        const auto outcome = pairlight(command);
        ASSERT_EQ(outcome.status, 0) << outcome.err;
    };
    simulate({});
    const auto machine = study / "machine.sqlite";
    std::filesystem::rename(study / "votes.sqlite", machine);
    simulate({"--window", window});
    EXPECT_EQ(pairlight({"verify", study.string()}).status, 0);
    const auto one = contents(machine);
    const auto other = contents(study / "votes.sqlite");
    for (const auto& [table, rows] : one) {
        EXPECT_EQ(rows.size(), other.at(table).size()) << table;
        EXPECT_TRUE(rows == other.at(table)) << table;
    }
    EXPECT_GT(one.at("votes").size(), 0u);
    EXPECT_GT(one.at("frames").size(), one.at("votes").size());
}

TEST(WindowAndMachine, LeaveTheSameStore) {
    const VirtualScreen screen(800, 600);
    const TemporaryFolder study;
    write_small_study(study.path());
    expect_same_stores(study.path(), 2, "640x400");
}

// The whole seed study, ten observers in three sittings of 57 trials: minutes, so it runs by name
// only (--gtest_also_run_disabled_tests --gtest_filter='*WholeSeedStudy*').
TEST(WindowAndMachine, DISABLED_LeaveTheSameStoreOfTheWholeSeedStudy) {
    const VirtualScreen screen(1280, 800);
    const TemporaryFolder study;
    write_seed_study(study.path());
    expect_same_stores(study.path(), 10, "1280x800");
    const SqliteDatabase votes(study / "votes.sqlite", WhenMissing::Fail);
    EXPECT_EQ(integer_of(votes.query("SELECT count(*) FROM votes")[0][0]), 1620);
    EXPECT_EQ(integer_of(votes.query("SELECT count(*) FROM planned WHERE phase = 'warmup'")[0][0]),
              90);
}

} // namespace
