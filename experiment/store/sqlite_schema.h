// The tables of a vote store in SQLite.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace experiment::store {

/// Version 2 adds tables to version 1 and changes none: answers, grades, frames, tombstones,
/// removed.
constexpr std::int64_t schema_version = 2;

/// "PLvt": tells a vote store from any other SQLite file.
constexpr std::int64_t application_id = 0x504c7674;

/// The statements that make an empty file a vote store.
std::string schema_sql();

/// The statements that make a store of version 1 one of version 2.
std::string upgrade_sql();

/// The tables that version 1 lacks, empty and for this connection only: what an older store is read
/// with.
std::string stand_ins_sql();

/// The names of a table's triggers, and the statements that make them.
struct Guard {
    std::string name;
    std::string sql;
};

std::vector<Guard> guards(const std::string& table);

/// The tables whose rows are chained.  Their first column is `seq`, counted over all of them
/// together, and their last one is `digest`.
const std::vector<std::string>& chained_tables();

} // namespace experiment::store
