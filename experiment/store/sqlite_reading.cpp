// Reading a vote store's SQLite file.
#include "experiment/store/sqlite_reading.h"

#include "experiment/store/row_chain.h"
#include "experiment/store/sqlite_panel.h"
#include "experiment/store/sqlite_schema.h"
#include "experiment/store/sqlite_withdrawal.h"
#include "experiment/store/vote_store.h"
#include "experiment/store/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace experiment::store {

namespace {

int small(const Value& value) {
    return static_cast<int>(integer_of(value));
}

std::optional<std::string> optional_text(const Value& value) {
    if (std::holds_alternative<std::monostate>(value))
        return std::nullopt;
    return text_of(value);
}

protocols::Choice choice(const SqliteDatabase& database, const Value& value) {
    if (const auto found = choice_of(text_of(value)))
        return *found;
    throw database.complaint(fmt::format("holds the answer \"{}\", expected left, right or tie; "
                                         "verify the store",
                                         text_of(value)));
}

protocols::Phase phase(const SqliteDatabase& database, const Value& value) {
    if (const auto found = phase_of(text_of(value)))
        return *found;
    throw database.complaint(fmt::format("holds the phase \"{}\", expected training, warmup or "
                                         "main; verify the store",
                                         text_of(value)));
}

SittingStart start_of(const Row& row) {
    return {{{text_of(row[1])}, small(row[2])},
            text_of(row[3]),
            text_of(row[4]),
            text_of(row[5]),
            text_of(row[6]),
            text_of(row[7]),
            text_of(row[8]),
            text_of(row[9]),
            text_of(row[10]),
            text_of(row[11]),
            text_of(row[12]),
            text_of(row[13]),
            optional_text(row[14]),
            optional_text(row[15])};
}

// Everything that lies on the chain, in the order it was written.
std::vector<ChainedRow> chained_rows(const SqliteDatabase& database) {
    std::vector<ChainedRow> rows;
    for (const auto& table : chained_tables())
        for (auto& row : database.query(fmt::format("SELECT * FROM {}", table))) {
            const auto* digest = std::get_if<std::string>(&row.back());
            ChainedRow chained{table, integer_of(row.front()), {}, digest ? *digest : ""};
            chained.values.assign(row.begin() + 1, row.end() - 1);
            rows.push_back(std::move(chained));
        }
    for (const auto& row : database.query("SELECT seq, digest FROM removed"))
        rows.push_back({"removed", integer_of(row[0]), {}, text_of(row[1]), true});
    std::ranges::stable_sort(rows, {}, &ChainedRow::seq);
    return rows;
}

void add_grades(std::vector<MainVote>& votes, const SqliteDatabase& database, const Row& sitting) {
    for (const auto& row :
         database.query("SELECT trial, grade FROM grades WHERE sitting = ?", sitting))
        for (auto& vote : votes)
            if (vote.trial == small(row[0]))
                vote.grade = small(row[1]);
}

// A vote's frames are those of its trial's last presentation; all others led to no vote.
void add_frames(Sitting& sitting, const SqliteDatabase& database, const Row& number) {
    std::map<int, int> last;
    for (const auto& shown : sitting.shown)
        last[shown.trial] = std::max(last[shown.trial], shown.presentation);
    for (const auto& row :
         database.query("SELECT trial, presentation, what, due_ns, done_ns, late FROM frames WHERE "
                        "sitting = ? ORDER BY seq",
                        number)) {
        const int trial = small(row[0]);
        const int presentation = small(row[1]);
        Frame frame{text_of(row[2]), integer_of(row[3]), integer_of(row[4]), small(row[5])};
        const auto vote = std::ranges::find(sitting.votes, trial, &MainVote::trial);
        if (vote != sitting.votes.end() && presentation == last[trial]) {
            vote->frames.push_back(std::move(frame));
            continue;
        }
        if (sitting.frames.empty() || sitting.frames.back().trial != trial ||
            sitting.frames.back().presentation != presentation)
            sitting.frames.push_back({trial, presentation, {}});
        sitting.frames.back().frames.push_back(std::move(frame));
    }
}

// A query whose rows are sitting, session, observer, count: one finding each.
void add_counts(std::vector<std::string>& findings,
                const SqliteDatabase& database,
                const std::string& sql,
                const std::string& what) {
    for (const auto& row : database.query(sql))
        findings.push_back(fmt::format("session {} of observer {}: {} {}", integer_of(row[1]),
                                       text_of(row[0]), integer_of(row[2]), what));
}

void add_contradictions(std::vector<std::string>& findings, const SqliteDatabase& database) {
    add_counts(findings, database,
               "SELECT observer, session, count(*) FROM finished JOIN sittings ON sittings.seq = "
               "finished.sitting JOIN planned ON planned.sitting = sittings.seq LEFT JOIN votes ON "
               "votes.sitting = planned.sitting AND votes.trial = planned.trial WHERE phase = "
               "'main' AND votes.seq IS NULL AND planned.trial NOT IN (SELECT CAST(detail AS "
               "INTEGER) FROM events WHERE sitting = sittings.seq AND kind = 'missing') GROUP BY "
               "sittings.seq",
               "main trial(s) have no vote though the session is finished");
    add_counts(findings, database,
               "SELECT observer, session, count(*) FROM votes JOIN sittings ON sittings.seq = "
               "votes.sitting LEFT JOIN shown ON shown.sitting = votes.sitting AND shown.trial = "
               "votes.trial WHERE shown.seq IS NULL GROUP BY sittings.seq",
               "vote(s) for trials that were never recorded as shown");
    add_counts(findings, database,
               "SELECT observer, session, count(*) FROM votes JOIN sittings ON sittings.seq = "
               "votes.sitting LEFT JOIN planned ON planned.sitting = votes.sitting AND "
               "planned.trial = votes.trial WHERE phase IS NULL OR phase <> 'main' GROUP BY "
               "sittings.seq",
               "vote(s) for trials that are not main trials");
    for (const auto& summary : read_summaries(database)) {
        const auto sitting = read_sitting(database, summary.key);
        if (plan_digest(sitting->plan) != sitting->start.plan_sha256)
            findings.push_back(fmt::format("session {} of observer {}: the plan is not the one the "
                                           "session began with",
                                           summary.key.session, summary.key.observer.value));
    }
}

} // namespace

Head read_head(const SqliteDatabase& database) {
    const auto rows = database.query("SELECT seq, digest FROM head WHERE one = 1");
    if (rows.empty())
        throw database.complaint("has lost the end of its chain; restore it from a copy");
    return {integer_of(rows[0][0]), text_of(rows[0][1])};
}

StudyIdentity read_study(const SqliteDatabase& database) {
    const auto rows = database.query("SELECT id, file_sha256 FROM study");
    if (rows.size() != 1)
        throw database.complaint(
            fmt::format("names {} studies, expected one; verify the store", rows.size()));
    return {text_of(rows[0][0]), text_of(rows[0][1])};
}

std::vector<protocols::ObserverId> read_observers(const SqliteDatabase& database) {
    std::vector<protocols::ObserverId> observers;
    for (const auto& row : database.query("SELECT observer FROM observers ORDER BY seq"))
        observers.push_back({text_of(row[0])});
    return observers;
}

std::vector<SittingSummary> read_summaries(const SqliteDatabase& database) {
    std::vector<SittingSummary> summaries;
    for (const auto& row : database.query(
             "SELECT sittings.*, finished.utc, (SELECT count(*) FROM votes WHERE sitting "
             "= sittings.seq) FROM sittings LEFT JOIN finished ON finished.sitting = "
             "sittings.seq ORDER BY sittings.seq")) {
        const auto start = start_of(row);
        summaries.push_back({start.key, start.local_date, start.started_utc, start.study_sha256,
                             start.renderer, start.display, start.timing_grade, start.simulation,
                             start.override_reason, optional_text(row[17]), small(row[18])});
    }
    return summaries;
}

std::optional<Sitting> read_sitting(const SqliteDatabase& database, const SittingKey& key) {
    const auto headers =
        database.query("SELECT sittings.*, finished.utc FROM sittings LEFT JOIN finished ON "
                       "finished.sitting = sittings.seq WHERE observer = ? AND session = ?",
                       {key.observer.value, std::int64_t{key.session}});
    if (headers.empty())
        return std::nullopt;
    const Row number{headers[0][0]};
    Sitting sitting{start_of(headers[0]), {}, {}, {}, {}, {}, optional_text(headers[0][17])};
    for (const auto& row :
         database.query("SELECT * FROM planned WHERE sitting = ? ORDER BY trial", number))
        sitting.plan.push_back(
            {small(row[2]),
             phase(database, row[3]),
             {{text_of(row[4])}, {text_of(row[5])}, {text_of(row[6])}, {text_of(row[7])}}});
    for (const auto& row :
         database.query("SELECT * FROM shown WHERE sitting = ? ORDER BY seq", number))
        sitting.shown.push_back({small(row[2]), small(row[3]), integer_of(row[4]), text_of(row[5]),
                                 text_of(row[6]), integer_of(row[7]), integer_of(row[8])});
    for (const auto& row :
         database.query("SELECT * FROM votes WHERE sitting = ? ORDER BY seq", number))
        sitting.votes.push_back({small(row[2]), choice(database, row[3]),
                                 std::chrono::milliseconds(integer_of(row[4])), integer_of(row[5]),
                                 integer_of(row[6]), text_of(row[7]), text_of(row[8]),
                                 text_of(row[9]), small(row[10]), integer_of(row[11]) == 1});
    add_grades(sitting.votes, database, number);
    add_frames(sitting, database, number);
    for (const auto& row :
         database.query("SELECT * FROM events WHERE sitting = ? ORDER BY seq", number))
        sitting.events.push_back(
            {text_of(row[2]), text_of(row[3]), integer_of(row[4]), text_of(row[5])});
    return sitting;
}

std::vector<Answer> read_answers(const SqliteDatabase& database,
                                 const protocols::ObserverId& observer) {
    std::vector<Answer> answers;
    for (const auto& row :
         database.query("SELECT question, answer, utc FROM answers WHERE observer = ? AND question "
                        "NOT IN (?, ?) ORDER BY seq",
                        {observer.value, place_question(ObserverKind::Person),
                         place_question(ObserverKind::Simulated)}))
        answers.push_back({text_of(row[0]), text_of(row[1]), text_of(row[2])});
    return answers;
}

std::vector<Tombstone> read_tombstones(const SqliteDatabase& database) {
    std::vector<Tombstone> tombstones;
    for (const auto& row :
         database.query("SELECT utc, reason, row_count, vote_count FROM tombstones ORDER BY seq"))
        tombstones.push_back({text_of(row[0]), text_of(row[1]), small(row[2]), small(row[3])});
    return tombstones;
}

std::vector<VoteRow> read_votes(const SqliteDatabase& database) {
    std::vector<VoteRow> votes;
    for (const auto& row : database.query(
             "SELECT long_votes.*, (SELECT grade FROM grades JOIN sittings ON sittings.seq = "
             "grades.sitting WHERE sittings.observer = long_votes.observer AND sittings.session = "
             "long_votes.session AND grades.trial = long_votes.trial) FROM long_votes"))
        votes.push_back(
            {text_of(row[0]),
             {text_of(row[1])},
             small(row[2]),
             small(row[3]),
             {{text_of(row[4])}, {text_of(row[5])}, {text_of(row[6])}, {text_of(row[7])}},
             choice(database, row[8]),
             std::chrono::milliseconds(integer_of(row[9])),
             text_of(row[10]),
             integer_of(row[11]) == 1,
             std::holds_alternative<std::monostate>(row[12]) ? std::nullopt
                                                             : std::optional(small(row[12]))});
    return votes;
}

std::vector<std::string> read_findings(const SqliteDatabase& database) {
    std::vector<std::string> findings;
    for (const auto& row : database.query("PRAGMA integrity_check"))
        if (text_of(row[0]) != "ok")
            findings.push_back("the file is damaged: " + text_of(row[0]));
    const auto head = read_head(database);
    for (const auto& broken : {chain_findings(chained_rows(database), head.seq, head.digest),
                               tombstone_findings(database)})
        findings.insert(findings.end(), broken.begin(), broken.end());
    try {
        add_contradictions(findings, database);
    } catch (const std::exception&) {
        if (findings.empty())
            throw;
        findings.push_back("the rows cannot be compared with each other before that is mended");
    }
    return findings;
}

} // namespace experiment::store
