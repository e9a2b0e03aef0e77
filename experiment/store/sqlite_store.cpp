// The vote store in one SQLite file: what is written, and in which order.
#include "experiment/store/sqlite_store.h"

#include "experiment/store/row_chain.h"
#include "experiment/store/sqlite_database.h"
#include "experiment/store/sqlite_panel.h"
#include "experiment/store/sqlite_reading.h"
#include "experiment/store/sqlite_rules.h"
#include "experiment/store/sqlite_schema.h"
#include "experiment/store/sqlite_withdrawal.h"
#include "experiment/store/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace experiment::store {

namespace {

using protocols::ObserverId;
using protocols::PlannedTrial;

Value text_or_nothing(const std::optional<std::string>& text) {
    return text ? Value(*text) : Value();
}

std::string word(auto enumerator) {
    return std::string(word_of(enumerator));
}

// Runs `work` on `file`; what the database throws becomes the error.
template <class Work>
auto attempt(const std::filesystem::path& file, Work work) -> Expected<decltype(work())> {
    try {
        if constexpr (std::is_void_v<decltype(work())>) {
            work();
            return {};
        } else {
            return work();
        }
    } catch (const DatabaseError& error) {
        return tl::unexpected(std::string(error.what()));
    } catch (const std::bad_variant_access&) { // a row's bytes say another type than its table does
        return tl::unexpected(fmt::format("{}: is damaged: a column holds another type than the "
                                          "schema says; restore it from a copy",
                                          file.string()));
    }
}

class SqliteStore final : public VoteStore {
  public:
    explicit SqliteStore(SqliteDatabase database) : database_(std::move(database)) {}

    /// Throws when this is no vote store, or one of a later version.  One of an earlier version is
    /// read as it is, with stand-ins for what it lacks.
    void check_format() {
        const auto found_id = integer_of(database_.query("PRAGMA application_id")[0][0]);
        const auto version = integer_of(database_.query("PRAGMA user_version")[0][0]);
        if (found_id != application_id)
            throw database_.complaint("is not a vote store of this program; expected the "
                                      "votes.sqlite of a study, or no file");
        if (version < 1 || version > schema_version)
            throw database_.complaint(fmt::format("has schema version {}, expected 1 to {}; use "
                                                  "the version of this program that wrote it",
                                                  version, schema_version));
        read_head(database_);
        is_older_ = version < schema_version;
        if (is_older_)
            database_.execute(stand_ins_sql());
    }

    /// Gives an older store the tables it lacks; what it holds is not touched.
    void upgrade() {
        if (!std::exchange(is_older_, false))
            return;
        for (const auto* table : {"answers", "grades", "frames", "tombstones", "removed"})
            database_.execute(fmt::format("DROP TABLE temp.{}", table));
        database_.in_transaction([&] { database_.execute(upgrade_sql()); });
    }

    void write_ahead() { database_.write_ahead(); }

    void check_writable() {
        if (database_.is_read_only())
            throw database_.complaint("cannot be written: the file or its folder is read-only");
        // A write and its undoing, to learn now whether it can be done.  (SQLite skips a write that
        // changes nothing.)
        database_.in_transaction([&] {
            database_.query("UPDATE head SET seq = seq + 1 WHERE one = 1");
            database_.query("UPDATE head SET seq = seq - 1 WHERE one = 1");
        });
    }

    void make_schema(const StudyIdentity& study) {
        database_.in_transaction([&] {
            database_.execute(schema_sql());
            append("study", {study.id, study.file_sha256});
        });
    }

    void check_study(const StudyIdentity& wanted) const {
        const auto found = read_study(database_);
        if (found.id != wanted.id)
            throw database_.complaint(
                fmt::format("holds the votes of study \"{}\", expected \"{}\"; "
                            "give this study a folder of its own",
                            found.id, wanted.id));
    }

    Expected<void> add_observer(const ObserverId& observer, const std::string& utc) override {
        return attempt(database_.file(), [&] {
            if (!is_pseudonym(observer.value))
                throw database_.complaint(fmt::format("observer \"{}\": expected a pseudonym of 1 "
                                                      "to 32 letters, digits, '-' and '_'",
                                                      observer.value));
            database_.in_transaction([&] {
                if (was_withdrawn(database_, observer))
                    throw database_.complaint(
                        fmt::format("observer {} was withdrawn at their wish; expected another "
                                    "pseudonym",
                                    observer.value));
                if (database_.query("SELECT 1 FROM observers WHERE observer = ?", {observer.value})
                        .empty())
                    append("observers", {observer.value, utc});
            });
        });
    }

    Expected<void>
    take_place(const ObserverId& observer, ObserverKind kind, const std::string& utc) override {
        return attempt(database_.file(), [&] {
            database_.in_transaction([&] {
                refuse_unknown(database_, observer);
                if (is_without_place(database_, observer))
                    append("answers", {observer.value, place_question(kind),
                                       std::to_string(free_place(database_, kind)), utc});
            });
        });
    }

    Expected<void> begin_sitting(const SittingStart& start,
                                 std::span<const PlannedTrial> plan) override {
        return attempt(database_.file(), [&] {
            database_.in_transaction([&] {
                refuse_if_begun(database_, start.key);
                refuse_mixed_observer(database_, start);
                const auto sitting = append(
                    "sittings",
                    {start.key.observer.value, std::int64_t{start.key.session}, start.study_sha256,
                     start.local_date, start.started_utc, start.generator, start.order_seed,
                     start.sides_seed, start.scene_rule, start.plan_sha256, start.renderer,
                     start.display, start.timing_grade, text_or_nothing(start.simulation),
                     text_or_nothing(start.override_reason)});
                for (const auto& [number, phase, trial] : plan)
                    append("planned",
                           {sitting, std::int64_t{number}, word(phase), trial.scene.value,
                            trial.variant.value, trial.left.value, trial.right.value});
            });
        });
    }

    Expected<void> append_shown(const SittingKey& key, const Shown& shown) override {
        return attempt(database_.file(), [&] {
            database_.in_transaction([&] {
                const auto sitting = open_sitting(database_, key);
                phase_of_trial(database_, key, sitting, shown.trial);
                append("shown",
                       {sitting, std::int64_t{shown.trial}, std::int64_t{shown.presentation},
                        shown.onset_ns, shown.onset_source, shown.onset_utc, shown.grey_ns,
                        shown.extra_ns});
            });
        });
    }

    Expected<void> append_vote(const SittingKey& key, const MainVote& vote) override {
        return attempt(database_.file(), [&] {
            database_.in_transaction([&] {
                const auto sitting = open_sitting(database_, key);
                refuse_vote(database_, key, sitting, vote.trial);
                append("votes", {sitting, std::int64_t{vote.trial}, word(vote.chosen),
                                 std::int64_t{vote.response_time.count()}, vote.onset_ns,
                                 vote.key_ns, vote.onset_utc, vote.device, vote.key_name,
                                 std::int64_t{vote.early_keys}, std::int64_t{vote.held_key}});
                if (vote.grade)
                    append("grades",
                           {sitting, std::int64_t{vote.trial}, std::int64_t{*vote.grade}});
                append_frames_of(sitting, vote.trial, last_presentation(sitting, vote.trial),
                                 vote.frames);
            });
        });
    }

    Expected<void> append_event(const SittingKey& key, const SittingEvent& event) override {
        return attempt(database_.file(), [&] {
            database_.in_transaction([&] {
                const auto sitting = open_sitting(database_, key);
                append("events", {sitting, event.kind, event.detail, event.at_ns, event.utc});
            });
        });
    }

    Expected<void> append_frames(const SittingKey& key, const FramesSeen& seen) override {
        return attempt(database_.file(), [&] {
            database_.in_transaction([&] {
                const auto sitting = open_sitting(database_, key);
                phase_of_trial(database_, key, sitting, seen.trial);
                append_frames_of(sitting, seen.trial, seen.presentation, seen.frames);
            });
        });
    }

    Expected<void> append_answers(const ObserverId& observer,
                                  std::span<const Answer> answers) override {
        return attempt(database_.file(), [&] {
            database_.in_transaction([&] {
                refuse_unknown(database_, observer);
                for (const auto& [question, answer, utc] : answers)
                    append("answers", {observer.value, question, answer, utc});
            });
        });
    }

    Expected<Tombstone> withdraw(const ObserverId& observer,
                                 const std::string& utc,
                                 const std::string& reason) override {
        return attempt(database_.file(), [&] {
            Tombstone tombstone{utc, reason, 0, 0};
            database_.keep_in_one_file();                   // a log would still hold the rows
            database_.execute("PRAGMA secure_delete = ON"); // zeros where the rows lay
            database_.in_transaction([&] {
                refuse_unknown(database_, observer);
                const auto removal = remove_observer(database_, observer);
                tombstone.rows = removal.rows;
                tombstone.votes = removal.votes;
                const auto seq = append(
                    "tombstones", {utc, reason, removal.observer_sha256, std::int64_t{removal.rows},
                                   std::int64_t{removal.votes}, removal.removed_sha256});
                database_.query("INSERT INTO removed SELECT seq, ?, digest FROM temp.leaving",
                                {seq});
                database_.execute("DROP TABLE temp.leaving");
            });
            return tombstone;
        });
    }

    Expected<void> finish_sitting(const SittingKey& key, const std::string& utc) override {
        return attempt(database_.file(), [&] {
            database_.in_transaction([&] {
                const auto sitting = open_sitting(database_, key);
                refuse_unanswered(database_, key, sitting);
                append("finished", {sitting, utc});
            });
        });
    }

    Expected<StudyIdentity> study() const override {
        return attempt(database_.file(), [&] { return read_study(database_); });
    }

    Expected<std::vector<ObserverId>> observers() const override {
        return attempt(database_.file(), [&] { return read_observers(database_); });
    }

    Expected<std::optional<ObserverId>> partner(const ObserverId& observer,
                                                ObserverKind kind) const override {
        return attempt(database_.file(), [&] { return partner_in(database_, observer, kind); });
    }

    Expected<std::vector<SittingSummary>> sittings() const override {
        return attempt(database_.file(), [&] { return read_summaries(database_); });
    }

    Expected<std::optional<Sitting>> sitting(const SittingKey& key) const override {
        return attempt(database_.file(), [&] { return read_sitting(database_, key); });
    }

    Expected<std::vector<VoteRow>> votes() const override {
        return attempt(database_.file(), [&] { return read_votes(database_); });
    }

    Expected<std::vector<Answer>> answers(const ObserverId& observer) const override {
        return attempt(database_.file(), [&] { return read_answers(database_, observer); });
    }

    Expected<std::vector<Tombstone>> tombstones() const override {
        return attempt(database_.file(), [&] { return read_tombstones(database_); });
    }

    Expected<std::vector<std::string>> verify() const override {
        return attempt(database_.file(), [&] { return read_findings(database_); });
    }

  private:
    // Appends one row to the chain, inside a transaction; returns its number.
    std::int64_t append(const std::string& table, Row values) {
        const auto head = read_head(database_);
        const ChainedRow row{table, head.seq + 1, std::move(values), {}};
        const auto digest = row_digest(head.digest, row);
        Row stored{row.seq};
        stored.insert(stored.end(), row.values.begin(), row.values.end());
        stored.emplace_back(digest);
        std::string sql = fmt::format("INSERT INTO {} VALUES (?", table);
        for (std::size_t i = 1; i < stored.size(); ++i)
            sql += ", ?";
        database_.query(sql + ")", stored);
        database_.query("UPDATE head SET seq = ?, digest = ? WHERE one = 1", {row.seq, digest});
        return row.seq;
    }

    void append_frames_of(std::int64_t sitting,
                          std::int64_t trial,
                          std::int64_t presentation,
                          const std::vector<Frame>& frames) {
        for (const auto& [what, due, done, late] : frames)
            append("frames", {sitting, trial, presentation, what, due, done, std::int64_t{late}});
    }

    std::int64_t last_presentation(std::int64_t sitting, std::int64_t trial) const {
        return integer_of(
            database_.query("SELECT max(presentation) FROM shown WHERE sitting = ? AND trial = ?",
                            {sitting, trial})[0][0]);
    }

    SqliteDatabase database_;
    bool is_older_ = false; ///< than this program's schema, and read with stand-ins
};

Expected<std::unique_ptr<VoteStore>> opened(const std::filesystem::path& file,
                                            WhenMissing when_missing,
                                            const std::function<void(SqliteStore&)>& prepare) {
    return attempt(file, [&]() -> std::unique_ptr<VoteStore> {
        auto store = std::make_unique<SqliteStore>(SqliteDatabase(file, when_missing));
        prepare(*store);
        return store;
    });
}

} // namespace

Expected<std::unique_ptr<VoteStore>> open_votes(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        return tl::unexpected(fmt::format("{}: there is no such file; expected the votes of at "
                                          "least one session",
                                          file.string()));
    return opened(file, WhenMissing::Fail, [](SqliteStore& store) { store.check_format(); });
}

Expected<std::unique_ptr<VoteStore>> open_or_create_votes(const std::filesystem::path& file,
                                                          const StudyIdentity& study) {
    std::error_code ignored;
    const bool is_there = std::filesystem::exists(file, ignored);
    if (is_there && std::filesystem::file_size(file, ignored) == 0)
        return tl::unexpected(fmt::format("{}: the file is empty; expected a vote store or no file "
                                          "(restore it from a copy, or remove it if it never held "
                                          "a vote)",
                                          file.string()));
    return opened(file, is_there ? WhenMissing::Fail : WhenMissing::Create,
                  [&](SqliteStore& store) {
                      if (!is_there)
                          store.make_schema(study);
                      store.check_format();
                      store.check_writable();
                      store.check_study(study);
                      store.upgrade();
                      store.write_ahead();
                  });
}

} // namespace experiment::store
