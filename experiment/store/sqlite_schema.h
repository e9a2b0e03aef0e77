// The tables of a vote store in SQLite.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace experiment::store {

constexpr std::int64_t schema_version = 1;

/// "PLvt": tells a vote store from any other SQLite file.
constexpr std::int64_t application_id = 0x504c7674;

/// The statements that make an empty file a vote store.
std::string schema_sql();

/// The tables whose rows are chained.  Their first column is `seq`, counted over all of them
/// together, and their last one is `digest`.
const std::vector<std::string>& chained_tables();

} // namespace experiment::store
