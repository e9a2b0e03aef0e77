// Places in the panel: who mirrors whose sides.
#pragma once

#include "experiment/store/records.h"
#include "experiment/store/sqlite_database.h"

#include <optional>

namespace experiment::store {

/// What the place of an observer is recorded as, among the answers about them; no study's question
/// has such an id.
std::string place_question(ObserverKind kind);

/// The lowest place that nobody of this kind has: that of somebody who left is given away again.
int free_place(const SqliteDatabase& database, ObserverKind kind);

/// Whether somebody has no place yet, and no sitting begun without one.
bool is_without_place(const SqliteDatabase& database, const protocols::ObserverId& observer);

/// The observer one place before, for those in every second place; whoever is without one is
/// thought to be in the free one of `kind`.  Empty: nobody, or one who has left, or the observer
/// sat before there were places.
std::optional<protocols::ObserverId> partner_in(const SqliteDatabase& database,
                                                const protocols::ObserverId& observer,
                                                ObserverKind kind);

} // namespace experiment::store
