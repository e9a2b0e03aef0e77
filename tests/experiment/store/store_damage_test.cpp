// What the world does to a vote store, and what is said about it.
#include "experiment/store/sqlite_database.h"
#include "experiment/store/sqlite_store.h"
#include "tests/experiment/store/small_sitting.h"
#include "tests/experiment/store/temporary_folder.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>

namespace {

using namespace experiment::store;
using protocols::Choice;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class StoreDamage : public testing::Test {
  protected:
    void SetUp() override {
        auto store = open_or_create_votes(file_, tests::study);
        ASSERT_TRUE(store) << store.error();
        ASSERT_TRUE((*store)->add_observer({"P1"}, "2026-03-01T08:59:00.000Z"));
        ASSERT_TRUE((*store)->begin_sitting(tests::start_of(key_), tests::small_plan()));
        for (const int trial : {3, 4, 5}) {
            ASSERT_TRUE((*store)->append_shown(key_, tests::shown(trial)));
            ASSERT_TRUE((*store)->append_vote(key_, tests::vote(trial, Choice::Left)));
        }
        ASSERT_TRUE((*store)->finish_sitting(key_, "2026-03-01T09:10:00.000Z"));
    }

    // Does to the file what the store would not.
    void tamper(const std::string& sql) {
        SqliteDatabase database(file_, WhenMissing::Fail);
        for (const auto& row :
             database.query("SELECT name FROM sqlite_schema WHERE type = 'trigger'"))
            database.execute("DROP TRIGGER " + text_of(row[0]));
        database.execute("PRAGMA foreign_keys = OFF; " + sql);
    }

    std::vector<std::string> findings() {
        const auto store = open_votes(file_);
        EXPECT_TRUE(store) << store.error();
        const auto found = (*store)->verify();
        EXPECT_TRUE(found) << found.error();
        return *found;
    }

    std::string bytes() const {
        std::ifstream stream(file_, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    void overwrite(const std::string& text) const {
        std::ofstream(file_, std::ios::binary | std::ios::trunc) << text;
    }

    std::string error_of_opening() const {
        const auto store = open_or_create_votes(file_, tests::study);
        return store ? "no error" : store.error();
    }

    tests::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "votes.sqlite";
    SittingKey key_ = tests::sitting_of("P1");
};

TEST_F(StoreDamage, AnUntouchedStoreHasNoFindings) {
    EXPECT_THAT(findings(), IsEmpty());
}

TEST_F(StoreDamage, TheFileItselfRefusesChanges) {
    SqliteDatabase database(file_, WhenMissing::Fail);
    EXPECT_THROW(database.execute("UPDATE votes SET chosen = 'right'"), DatabaseError);
    EXPECT_THROW(database.execute("DELETE FROM votes"), DatabaseError);
    EXPECT_THAT(findings(), IsEmpty());
}

TEST_F(StoreDamage, AChangedVoteIsFound) {
    tamper("UPDATE votes SET chosen = 'right' WHERE trial = 4");
    EXPECT_THAT(findings(), ElementsAre(AllOf(HasSubstr("(votes 3 4 right"),
                                              HasSubstr("was changed after it was written"))));
}

TEST_F(StoreDamage, AMissingVoteIsFoundTwice) {
    tamper("DELETE FROM votes WHERE trial = 4");
    EXPECT_THAT(findings(),
                ElementsAre(HasSubstr("is missing"),
                            "session 1 of observer P1: 1 main trial(s) have no vote though the "
                            "session is finished"));
}

TEST_F(StoreDamage, SwappedVotesAreFound) {
    tamper("UPDATE votes SET trial = 99 WHERE trial = 3; UPDATE votes SET trial = 3 WHERE trial = "
           "5; UPDATE votes SET trial = 5 WHERE trial = 99");
    EXPECT_EQ(findings().size(), 2u);
}

TEST_F(StoreDamage, ALostEndIsFound) {
    tamper("DELETE FROM finished");
    EXPECT_THAT(findings(), ElementsAre("1 row(s) are missing at the end"));
}

TEST_F(StoreDamage, AChangedPlanIsFound) {
    tamper("UPDATE planned SET left_condition = right_condition, right_condition = left_condition "
           "WHERE trial = 4");
    EXPECT_THAT(findings(), ElementsAre(HasSubstr("was changed after it was written"),
                                        HasSubstr("the plan is not the one the session began "
                                                  "with")));
}

// Any single damaged byte either breaks the file, or is found, or leaves every row as it was.
TEST_F(StoreDamage, NoSingleByteChangesAVoteUnseen) {
    const auto intact = bytes();
    const auto votes = *(*open_votes(file_))->votes();
    int seen = 0;
    for (std::size_t position = 101; position < intact.size(); position += 397) {
        auto damaged = intact;
        damaged[position] = static_cast<char>(damaged[position] ^ 0x04);
        overwrite(damaged);
        const auto store = open_votes(file_);
        if (!store) {
            EXPECT_THAT(store.error(), HasSubstr(file_.string()));
            ++seen;
            continue;
        }
        const auto found = (*store)->verify();
        const auto read = (*store)->votes();
        if (found && found->empty() && read)
            EXPECT_EQ(*read, votes) << "byte " << position;
        else
            ++seen;
    }
    EXPECT_GT(seen, 5);
}

TEST_F(StoreDamage, AFileThatIsNoDatabaseIsRefusedAndLeftAlone) {
    overwrite(std::string(5000, 'x'));
    EXPECT_THAT(error_of_opening(),
                AllOf(HasSubstr(file_.string()), HasSubstr("damaged or not a vote store")));
    EXPECT_EQ(bytes(), std::string(5000, 'x'));
}

TEST_F(StoreDamage, ATruncatedFileIsRefused) {
    overwrite(bytes().substr(0, 9000));
    EXPECT_THAT(error_of_opening(), HasSubstr("damaged"));
}

TEST_F(StoreDamage, AnEmptyFileIsRefused) {
    overwrite("");
    EXPECT_THAT(error_of_opening(), HasSubstr("the file is empty; expected a vote store or no"));
}

TEST_F(StoreDamage, AnotherProgramsDatabaseIsRefused) {
    std::filesystem::remove(file_);
    SqliteDatabase(file_, WhenMissing::Create).execute("CREATE TABLE notes (text)");
    EXPECT_THAT(error_of_opening(), HasSubstr("is not a vote store of this program"));
}

TEST_F(StoreDamage, AnotherSchemaVersionIsRefused) {
    tamper("PRAGMA user_version = 3");
    EXPECT_THAT(error_of_opening(), HasSubstr("has schema version 3, expected 1 to 2"));
    EXPECT_THAT(open_votes(file_).error(), HasSubstr("has schema version 3, expected 1 to 2"));
}

TEST_F(StoreDamage, AnotherStudysVotesAreRefused) {
    EXPECT_THAT(open_or_create_votes(file_, {"other", ""}).error(),
                HasSubstr("holds the votes of study \"glow\", expected \"other\""));
}

TEST_F(StoreDamage, AStudyFileThatChangedIsWelcome) {
    EXPECT_TRUE(open_or_create_votes(file_, {"glow", std::string(64, 'b')}));
}

TEST_F(StoreDamage, AnotherProgramThatIsWritingIsNamed) {
    SqliteDatabase other(file_, WhenMissing::Fail);
    other.execute("BEGIN IMMEDIATE");
    EXPECT_THAT(error_of_opening(),
                AllOf(HasSubstr(file_.string()), HasSubstr("another program is writing to it")));
}

/// An open sitting beside the finished one, its main trials shown and not answered.
class OpenSitting : public StoreDamage {
  protected:
    void SetUp() override {
        StoreDamage::SetUp();
        store_ = *open_or_create_votes(file_, tests::study);
        ASSERT_TRUE(store_->add_observer({"P2"}, "2026-03-01T08:59:00.000Z"));
        ASSERT_TRUE(store_->begin_sitting(tests::start_of(open_), tests::small_plan()));
        for (const int trial : {3, 4, 5})
            ASSERT_TRUE(store_->append_shown(open_, tests::shown(trial)));
    }

    std::unique_ptr<VoteStore> store_;
    const SittingKey open_ = tests::sitting_of("P2");
};

TEST_F(OpenSitting, RefusesAVoteWhileAnotherProgramHoldsTheFileAndTakesItAfterwards) {
    {
        SqliteDatabase other(file_, WhenMissing::Fail);
        other.execute("BEGIN IMMEDIATE");
        EXPECT_THAT(store_->append_vote(open_, tests::vote(3, Choice::Left)).error(),
                    HasSubstr("another program is writing to it"));
        EXPECT_THAT(store_->votes()->size(), 3u); // the finished sitting's
    }
    EXPECT_TRUE(store_->append_vote(open_, tests::vote(3, Choice::Left)));
    EXPECT_EQ(store_->votes()->size(), 4u);
    EXPECT_THAT(*store_->verify(), IsEmpty());
}

/// Files of this process cannot grow beyond a size while this lives, as on a full disk.
class FullDisk {
  public:
    explicit FullDisk(std::uintmax_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }

    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    void (*handler_)(int);
    rlimit before_{};
};

TEST_F(OpenSitting, LosesNoVoteToAFullDiskAndInventsNone) {
    std::size_t kept = 0;
    {
        const FullDisk full(std::filesystem::file_size(file_));
        const SittingEvent long_event{"remark", std::string(3000, 'x'), 0, ""};
        bool failed = false;
        for (int i = 0; i < 100 && !failed; ++i)
            failed = !store_->append_event(open_, long_event);
        EXPECT_TRUE(failed) << "the disk was never full";
        for (const int trial : {3, 4, 5})
            if (store_->append_vote(open_, tests::vote(trial, Choice::Right)))
                ++kept;
        EXPECT_EQ(store_->votes()->size(), 3 + kept);
    }
    EXPECT_EQ((*open_votes(file_))->votes()->size(), 3 + kept);
    EXPECT_THAT(findings(), IsEmpty());
    const auto again = open_or_create_votes(file_, tests::study);
    ASSERT_TRUE(again) << again.error();
    const auto votes = (**(*again)->sitting(open_)).votes;
    for (const int trial : {3, 4, 5})
        if (std::ranges::find(votes, trial, &MainVote::trial) == votes.end()) {
            EXPECT_TRUE((*again)->append_vote(open_, tests::vote(trial, Choice::Right)));
        }
    EXPECT_EQ((*again)->votes()->size(), 6u);
    EXPECT_THAT(findings(), IsEmpty());
}

TEST_F(StoreDamage, AMissingStoreIsSaidToBeMissing) {
    EXPECT_THAT(open_votes(folder_.path() / "none.sqlite").error(),
                HasSubstr("none.sqlite: there is no such file"));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "none.sqlite"));
}

// Permissions mean nothing to root: such a test is run as nobody.
class AsNobody {
  public:
    AsNobody() {
        if (geteuid() == 0)
            was_root_ = seteuid(65534) == 0;
    }

    ~AsNobody() {
        if (was_root_ && seteuid(0) != 0)
            std::abort();
    }

  private:
    bool was_root_ = false;
};

TEST_F(StoreDamage, AReadOnlyFolderIsRefusedForVotingAndFineForReading) {
    chmod(file_.c_str(), 0444);
    chmod(folder_.path().c_str(), 0555);
    const auto before = bytes();
    {
        const AsNobody nobody;
        EXPECT_THAT(error_of_opening(),
                    AllOf(HasSubstr(file_.string()), HasSubstr("cannot be written")));
        EXPECT_THAT(open_or_create_votes(folder_.path() / "new.sqlite", tests::study).error(),
                    AllOf(HasSubstr("new.sqlite"), HasSubstr("cannot be opened or written")));
        const auto store = open_votes(file_);
        ASSERT_TRUE(store) << store.error();
        EXPECT_EQ((*store)->votes()->size(), 3u);
        EXPECT_THAT(*(*store)->verify(), IsEmpty());
    }
    chmod(folder_.path().c_str(), 0755);
    EXPECT_EQ(bytes(), before);
}

TEST_F(StoreDamage, AWritableFileInAReadOnlyFolderIsRefusedForVoting) {
    chmod(file_.c_str(), 0666);
    chmod(folder_.path().c_str(), 0555);
    {
        const AsNobody nobody;
        EXPECT_THAT(error_of_opening(),
                    AllOf(HasSubstr(file_.string()), HasSubstr("cannot be written")));
    }
    chmod(folder_.path().c_str(), 0755);
    EXPECT_THAT(findings(), IsEmpty());
}

} // namespace
