#include "experiment/store/sqlite_database.h"
#include "experiment/store/sqlite_store.h"
#include "tests/experiment/store/small_sitting.h"
#include "tests/experiment/store/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace {

using namespace experiment::store;
using protocols::Choice;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr auto utc = "2026-03-02T09:00:00.000Z";

class Withdrawal : public testing::Test {
  protected:
    void SetUp() override {
        store_ = *open_or_create_votes(file_, tests::study);
        for (const auto* observer : {"EARLY", "LEAVES", "LATE"})
            fill(observer);
    }

    void fill(const std::string& observer) {
        const auto key = tests::sitting_of(observer);
        ASSERT_TRUE(store_->add_observer({observer}, utc));
        const std::vector<Answer> answers{{"acuity", "0.8", utc}, {"screening", "passed", utc}};
        ASSERT_TRUE(store_->append_answers({observer}, answers));
        ASSERT_TRUE(store_->begin_sitting(tests::start_of(key), tests::small_plan()));
        for (int trial = 1; trial <= 5; ++trial) {
            ASSERT_TRUE(store_->append_shown(key, tests::shown(trial)));
            auto vote = tests::vote(trial, Choice::Right);
            vote.grade = 2;
            vote.frames = {{"grey", 1, 2, 0}, {"pair", 3, 5, 1}};
            if (trial > 2)
                ASSERT_TRUE(store_->append_vote(key, vote));
            else
                ASSERT_TRUE(store_->append_frames(key, {trial, 1, {{"grey", 1, 2, 0}}}));
        }
        ASSERT_TRUE(store_->append_event(key, {"page", "questions", 5, utc}));
        ASSERT_TRUE(store_->finish_sitting(key, utc));
    }

    /// Of the file and of the log beside it.
    std::string bytes() const {
        std::stringstream text;
        for (const auto& name : {file_.string(), file_.string() + "-wal"})
            if (std::ifstream file(name, std::ios::binary); file.peek() != EOF)
                text << file.rdbuf();
        return text.str();
    }

    /// Changes the file as a hex editor would, past the guards.
    void tamper(const std::string& sql) {
        store_.reset();
        SqliteDatabase database(file_, WhenMissing::Fail);
        database.execute("PRAGMA writable_schema = ON; PRAGMA foreign_keys = OFF");
        for (const auto& row : database.query("SELECT name FROM sqlite_schema WHERE type = "
                                              "'trigger'"))
            database.execute("DROP TRIGGER " + text_of(row[0]));
        database.execute(sql);
    }

    std::vector<std::string> findings() const { return *(*open_votes(file_))->verify(); }

    tests::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "votes.sqlite";
    std::unique_ptr<VoteStore> store_;
};

TEST_F(Withdrawal, GivesBackWhatWasWrittenBefore) {
    const auto sitting = **store_->sitting(tests::sitting_of("LATE"));
    ASSERT_THAT(sitting.votes, SizeIs(3));
    EXPECT_EQ(sitting.votes[0].grade, 2);
    EXPECT_THAT(sitting.votes[0].frames,
                ElementsAre(Frame{"grey", 1, 2, 0}, Frame{"pair", 3, 5, 1}));
    EXPECT_THAT(sitting.frames, SizeIs(2));
    EXPECT_THAT(*store_->answers({"LATE"}),
                ElementsAre(Answer{"acuity", "0.8", utc}, Answer{"screening", "passed", utc}));
    EXPECT_THAT(*store_->verify(), IsEmpty());
}

TEST_F(Withdrawal, RemovesEverythingOfOneObserverAndNothingElse) {
    const auto votes = *store_->votes();
    const auto tombstone = store_->withdraw({"LEAVES"}, utc, "asked to");
    ASSERT_TRUE(tombstone) << tombstone.error();
    EXPECT_EQ(tombstone->votes, 3);
    // One observer, two answers, a sitting, five trials planned and shown, two frames of practice,
    // three votes with a grade and two frames each, an event, an end.
    EXPECT_EQ(tombstone->rows, 1 + 2 + 1 + 5 + 5 + 2 + 3 * 4 + 1 + 1);
    EXPECT_THAT(*store_->votes(), SizeIs(votes.size() - 3));
    const auto left = *store_->votes();
    for (const auto& vote : left)
        EXPECT_NE(vote.observer.value, "LEAVES");
    EXPECT_THAT(*store_->observers(), SizeIs(2));
    EXPECT_EQ(*store_->sitting(tests::sitting_of("LEAVES")), std::nullopt);
    EXPECT_THAT(*store_->answers({"LEAVES"}), IsEmpty());
    EXPECT_THAT(*store_->tombstones(), ElementsAre(*tombstone));
}

TEST_F(Withdrawal, LeavesARecordThatCanStillBeProvedWhole) {
    for (const auto* observer : {"LEAVES", "LATE", "EARLY"}) { // in the middle, the end, the start
        ASSERT_TRUE(store_->withdraw({observer}, utc, "asked to"));
        EXPECT_THAT(*store_->verify(), IsEmpty()) << observer;
    }
    EXPECT_THAT(*store_->tombstones(), SizeIs(3));
}

TEST_F(Withdrawal, LeavesNoTraceOfThePseudonymInTheFile) {
    ASSERT_THAT(bytes(), HasSubstr("LEAVES"));
    ASSERT_TRUE(store_->withdraw({"LEAVES"}, utc, "asked to"));
    EXPECT_EQ(bytes().find("LEAVES"), std::string::npos);
    EXPECT_NE(bytes().find("EARLY"), std::string::npos);
}

TEST_F(Withdrawal, IsForGood) {
    ASSERT_TRUE(store_->withdraw({"LEAVES"}, utc, "asked to"));
    EXPECT_THAT(store_->add_observer({"LEAVES"}, utc).error(), HasSubstr("was withdrawn"));
    EXPECT_THAT(store_->withdraw({"LEAVES"}, utc, "again").error(), HasSubstr("knows no observer"));
    fill("NEW"); // others come and go on
    EXPECT_THAT(*store_->verify(), IsEmpty());
}

TEST_F(Withdrawal, IsAllOrNothing) {
    const auto votes = *store_->votes();
    EXPECT_FALSE(store_->withdraw({"NOBODY"}, utc, "asked to"));
    EXPECT_THAT(*store_->tombstones(), IsEmpty());
    EXPECT_THAT(*store_->votes(), SizeIs(votes.size()));
    EXPECT_THAT(*store_->observers(), SizeIs(3));
    EXPECT_THAT(*store_->verify(), IsEmpty());
}

TEST_F(Withdrawal, CannotBeForgedByDeletingRows) {
    tamper("DELETE FROM votes WHERE seq = (SELECT max(seq) FROM votes)");
    EXPECT_THAT(findings(), Contains(HasSubstr("is missing")));
}

TEST_F(Withdrawal, CannotBeForgedByNamingDeletedRowsAsRemoved) {
    tamper("INSERT INTO removed SELECT seq, 1, digest FROM votes WHERE seq = (SELECT max(seq) FROM "
           "votes); DELETE FROM votes WHERE seq = (SELECT max(seq) FROM votes)");
    EXPECT_THAT(findings(), Contains(HasSubstr("removed without a tombstone")));
}

TEST_F(Withdrawal, CannotBeWidenedAfterwards) {
    ASSERT_TRUE(store_->withdraw({"LEAVES"}, utc, "asked to"));
    tamper(
        "INSERT INTO removed SELECT seq, (SELECT seq FROM tombstones), digest FROM votes WHERE "
        "seq = (SELECT max(seq) FROM votes); DELETE FROM votes WHERE seq = (SELECT max(seq) FROM "
        "votes)");
    EXPECT_THAT(findings(), Contains(HasSubstr("removed rows, but")));
}

TEST_F(Withdrawal, KeepsItsGuardsUp) {
    ASSERT_TRUE(store_->withdraw({"LEAVES"}, utc, "asked to"));
    store_.reset();
    SqliteDatabase database(file_, WhenMissing::Fail);
    for (const auto* table : {"votes", "answers", "frames", "removed", "tombstones"})
        EXPECT_THROW(database.execute(std::string("DELETE FROM ") + table), DatabaseError) << table;
}

} // namespace
