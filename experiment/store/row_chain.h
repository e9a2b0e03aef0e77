// The chain that holds the rows of a vote store together.
#pragma once

#include "experiment/store/sqlite_database.h"

#include <cstdint>
#include <string>
#include <vector>

namespace experiment::store {

/// A row as it lies in its table, without its first column (`seq`) and its last one (`digest`).
struct ChainedRow {
    std::string table;
    std::int64_t seq = 0; ///< 1, 2, 3, ... over all tables
    Row values;
    std::string digest;
    bool removed = false; ///< only its number and digest are left, and a tombstone says why
};

/// SHA-256, hexadecimal, over the predecessor's digest, the table's name, the number and the
/// values.
std::string row_digest(const std::string& predecessor, const ChainedRow& row);

/// What is wrong with a chain, one line each.  `rows` are in order of `seq`; the head is the number
/// and the digest that the last row should have.
std::vector<std::string> chain_findings(const std::vector<ChainedRow>& rows,
                                        std::int64_t head_seq,
                                        const std::string& head_digest);

} // namespace experiment::store
