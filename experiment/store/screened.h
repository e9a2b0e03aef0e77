// Whom BT.500 counts: people who passed the screening and finished a sitting.
#pragma once

#include "experiment/store/vote_store.h"

#include <set>

namespace experiment::store {

/// ITU-R BT.500: a study with fewer of them is to be called informal.
inline constexpr std::size_t formal_observers = 15;

Expected<std::set<protocols::ObserverId>> screened_observers(const VoteStore& store);

} // namespace experiment::store
