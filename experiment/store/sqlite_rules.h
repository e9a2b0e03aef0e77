// What may be added to a vote store, and what may not.  Everything throws DatabaseError, which says
// why.
#pragma once

#include "experiment/store/records.h"
#include "experiment/store/sqlite_database.h"
#include "protocols/vocabulary.h"

#include <cstdint>
#include <string>

namespace experiment::store {

/// An observer who was never added.
void refuse_unknown(const SqliteDatabase& database, const protocols::ObserverId& observer);

/// A sitting that is there, finished or not.
void refuse_if_begun(const SqliteDatabase& database, const SittingKey& key);

/// A person's sitting after a simulated one of the same observer, and the other way round.
void refuse_mixed_observer(const SqliteDatabase& database, const SittingStart& start);

/// The number of a sitting that may still be written to.
std::int64_t open_sitting(const SqliteDatabase& database, const SittingKey& key);

/// The phase of a trial, which has to be in the sitting's plan.
std::string phase_of_trial(const SqliteDatabase& database,
                           const SittingKey& key,
                           std::int64_t sitting,
                           std::int64_t trial);

/// A vote for what is no main trial, was not shown, has a vote, or is on record as missing.
void refuse_vote(const SqliteDatabase& database,
                 const SittingKey& key,
                 std::int64_t sitting,
                 std::int64_t trial);

/// The end of a sitting with main trials that have no vote and are not on record as missing.
void refuse_unanswered(const SqliteDatabase& database, const SittingKey& key, std::int64_t sitting);

} // namespace experiment::store
