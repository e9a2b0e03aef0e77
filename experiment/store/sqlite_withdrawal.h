// Removing an observer from a vote store, at their wish.  Everything throws DatabaseError.
#pragma once

#include "experiment/store/sqlite_database.h"
#include "protocols/vocabulary.h"

#include <string>
#include <vector>

namespace experiment::store {

struct Removal {
    int rows = 0;
    int votes = 0;
    std::string observer_sha256; ///< over the study's id and the pseudonym
    std::string removed_sha256;  ///< over the numbers and digests of the rows
};

/// Deletes every row of an observer, inside the caller's transaction.  Their numbers and digests
/// are left in the table temp.leaving, for the caller to keep and drop.
Removal remove_observer(SqliteDatabase& database, const protocols::ObserverId& observer);

bool was_withdrawn(const SqliteDatabase& database, const protocols::ObserverId& observer);

/// What is wrong between tombstones and the rows they stand for, one line each.
std::vector<std::string> tombstone_findings(const SqliteDatabase& database);

} // namespace experiment::store
