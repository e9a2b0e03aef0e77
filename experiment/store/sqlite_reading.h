// Reading a vote store's SQLite file: rows to values.  Everything throws DatabaseError.
#pragma once

#include "experiment/store/records.h"
#include "experiment/store/sqlite_database.h"

#include <optional>
#include <string>
#include <vector>

namespace experiment::store {

/// The last link of the chain.
struct Head {
    std::int64_t seq = 0;
    std::string digest;
};

Head read_head(const SqliteDatabase& database);
StudyIdentity read_study(const SqliteDatabase& database);
std::vector<protocols::ObserverId> read_observers(const SqliteDatabase& database);
std::vector<SittingSummary> read_summaries(const SqliteDatabase& database);
std::optional<Sitting> read_sitting(const SqliteDatabase& database, const SittingKey& key);
std::vector<VoteRow> read_votes(const SqliteDatabase& database);

std::vector<Answer> read_answers(const SqliteDatabase& database,
                                 const protocols::ObserverId& observer);
std::vector<Tombstone> read_tombstones(const SqliteDatabase& database);

/// What `VoteStore::verify` says.
std::vector<std::string> read_findings(const SqliteDatabase& database);

} // namespace experiment::store
