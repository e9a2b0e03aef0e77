#include "experiment/store/sqlite_rules.h"

#include "experiment/store/words.h"

#include <fmt/format.h>

namespace experiment::store {

namespace {

DatabaseError
complaint(const SqliteDatabase& database, const SittingKey& key, const std::string& message) {
    return database.complaint(
        fmt::format("session {} of observer {} {}", key.session, key.observer.value, message));
}

std::vector<Row> find(const SqliteDatabase& database, const SittingKey& key) {
    return database.query("SELECT sittings.seq, local_date, finished.utc FROM sittings LEFT "
                          "JOIN finished ON finished.sitting = sittings.seq WHERE observer = "
                          "? AND session = ?",
                          {key.observer.value, std::int64_t{key.session}});
}

} // namespace

void refuse_unknown(const SqliteDatabase& database, const protocols::ObserverId& observer) {
    if (database.query("SELECT 1 FROM observers WHERE observer = ?", {observer.value}).empty())
        throw database.complaint(
            fmt::format("knows no observer {}; `pairlight observers` lists them", observer.value));
}

void refuse_if_begun(const SqliteDatabase& database, const SittingKey& key) {
    const auto found = find(database, key);
    if (found.empty())
        return;
    if (std::holds_alternative<std::string>(found[0][2]))
        throw complaint(database, key,
                        fmt::format("is finished (begun on {}); its votes stand, expected "
                                    "another session number",
                                    text_of(found[0][1])));
    throw complaint(database, key,
                    fmt::format("was begun on {} and is not finished; expected to go on "
                                "with it",
                                text_of(found[0][1])));
}

void refuse_mixed_observer(const SqliteDatabase& database, const SittingStart& start) {
    const auto found =
        database.query("SELECT session FROM sittings WHERE observer = ? AND "
                       "(simulation IS NOT NULL) <> ?",
                       {start.key.observer.value, std::int64_t{start.simulation.has_value()}});
    if (!found.empty())
        throw complaint(database, start.key,
                        fmt::format("would be {}, but session {} was {}; expected another observer",
                                    start.simulation ? "simulated" : "a person's",
                                    integer_of(found[0][0]),
                                    start.simulation ? "a person's" : "simulated"));
}

std::int64_t open_sitting(const SqliteDatabase& database, const SittingKey& key) {
    const auto found = find(database, key);
    if (found.empty())
        throw complaint(database, key, "was never begun");
    if (std::holds_alternative<std::string>(found[0][2]))
        throw complaint(database, key, "is finished; nothing can be added to it");
    return integer_of(found[0][0]);
}

std::string phase_of_trial(const SqliteDatabase& database,
                           const SittingKey& key,
                           std::int64_t sitting,
                           std::int64_t trial) {
    const auto found = database.query("SELECT phase FROM planned WHERE sitting = ? AND trial = ?",
                                      {sitting, trial});
    if (found.empty())
        throw complaint(database, key, fmt::format("has no trial {} in its plan", trial));
    return text_of(found[0][0]);
}

void refuse_vote(const SqliteDatabase& database,
                 const SittingKey& key,
                 std::int64_t sitting,
                 std::int64_t trial) {
    const auto has = [&](const char* table) {
        return !database
                    .query(fmt::format("SELECT 1 FROM {} WHERE sitting = ? AND trial = ?", table),
                           {sitting, trial})
                    .empty();
    };
    const auto phase = phase_of_trial(database, key, sitting, trial);
    if (phase != word_of(protocols::Phase::Main))
        throw complaint(database, key,
                        fmt::format("cannot keep a vote for trial {}, which is {}", trial, phase));
    if (!has("shown"))
        throw complaint(database, key,
                        fmt::format("cannot keep a vote for trial {}, which was not "
                                    "recorded as shown",
                                    trial));
    if (has("votes"))
        throw complaint(database, key, fmt::format("has a vote for trial {} already", trial));
    if (!database
             .query("SELECT 1 FROM events WHERE sitting = ? AND kind = ? AND detail = ?",
                    {sitting, std::string(missing_vote), std::to_string(trial)})
             .empty())
        throw complaint(database, key, fmt::format("has trial {} on record as missing", trial));
}

void refuse_unanswered(const SqliteDatabase& database,
                       const SittingKey& key,
                       std::int64_t sitting) {
    const auto open = database.query(
        "SELECT trial FROM planned WHERE sitting = ? AND phase = 'main' AND trial NOT "
        "IN (SELECT trial FROM votes WHERE sitting = planned.sitting) AND trial NOT IN "
        "(SELECT CAST(detail AS INTEGER) FROM events WHERE sitting = planned.sitting "
        "AND kind = ?) ORDER BY trial",
        {sitting, std::string(missing_vote)});
    if (!open.empty())
        throw complaint(database, key,
                        fmt::format("cannot be finished: {} main trial(s) have no "
                                    "vote, the first is number {}",
                                    open.size(), integer_of(open[0][0])));
}

} // namespace experiment::store
