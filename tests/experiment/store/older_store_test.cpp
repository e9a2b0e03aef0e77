// A store of version 1, as an earlier program left it.
#include "experiment/store/sqlite_database.h"
#include "experiment/store/sqlite_store.h"
#include "tests/experiment/store/small_sitting.h"
#include "tests/experiment/store/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace experiment::store;
using testing::IsEmpty;
using testing::SizeIs;

class OlderStore : public testing::Test {
  protected:
    /// One sitting with one vote, in a file that knows nothing of what version 2 added.
    void SetUp() override {
        {
            const auto key = tests::sitting_of("P1");
            const auto store = *open_or_create_votes(file_, tests::study);
            ASSERT_TRUE(store->add_observer({"P1"}, ""));
            ASSERT_TRUE(store->begin_sitting(tests::start_of(key), tests::small_plan()));
            ASSERT_TRUE(store->append_shown(key, tests::shown(3)));
            ASSERT_TRUE(store->append_vote(key, tests::vote(3, protocols::Choice::Left)));
        }
        SqliteDatabase database(file_, WhenMissing::Fail);
        for (const auto* table : {"answers", "grades", "frames", "tombstones", "removed"})
            database.execute(std::string("DROP TABLE ") + table);
        database.execute("PRAGMA user_version = 1");
    }

    std::int64_t version() const {
        const SqliteDatabase database(file_, WhenMissing::Fail);
        return integer_of(database.query("PRAGMA user_version")[0][0]);
    }

    tests::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "votes.sqlite";
};

TEST_F(OlderStore, IsReadAsItIsAndNotTouched) {
    {
        const auto store = open_votes(file_);
        ASSERT_TRUE(store) << store.error();
        EXPECT_THAT(*(*store)->verify(), IsEmpty());
        EXPECT_THAT(*(*store)->votes(), SizeIs(1));
        EXPECT_THAT(*(*store)->answers({"P1"}), IsEmpty());
        EXPECT_THAT((**(*store)->sitting(tests::sitting_of("P1"))).votes, SizeIs(1));
    }
    EXPECT_EQ(version(), 1);
}

TEST_F(OlderStore, GrowsWhatItLacksWhenASittingGoesOn) {
    const auto key = tests::sitting_of("P1");
    const auto store = open_or_create_votes(file_, tests::study);
    ASSERT_TRUE(store) << store.error();
    ASSERT_TRUE((*store)->append_shown(key, tests::shown(4)));
    auto vote = tests::vote(4, protocols::Choice::Right);
    vote.grade = 1;
    vote.frames = {{"pair", 1, 2, 0}};
    const auto appended = (*store)->append_vote(key, vote);
    ASSERT_TRUE(appended) << appended.error();
    EXPECT_THAT(*(*store)->verify(), IsEmpty());
    EXPECT_EQ((**(*store)->sitting(key)).votes.back().grade, 1);
    EXPECT_EQ(version(), 2);
}

} // namespace
