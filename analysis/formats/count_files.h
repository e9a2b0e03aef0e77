// Counts of who was chosen over whom, as tables and matrices.
#pragma once

#include "analysis/vote_table.h"

#include <string>
#include <string_view>

namespace analysis::formats {

/// More votes than a table of single votes should hold.
inline constexpr std::int64_t most_votes = 20'000'000;

/// Rows of `winner`, `loser` and how often (`votes` or `count`; 1 without), or of `player1`,
/// `player2`, `win1`, `win2` and `ties`; other columns are `observer`, `session` or scene factors.
/// With a column `scope`, as the program's own matrices have, the finest scope is read and the
/// pooled ones passed over.  Two numbers a row without a header are winner and loser.
/// Errors: `name:line: ...` for what is not a count, a condition against itself, too many votes,
/// scopes of which none is the finest, ties that differ between a pair's two rows.
Expected<VoteTable> read_pair_counts(std::string_view text, const std::string& name);

/// A square matrix of counts, row chosen over column.  With a header row its first name is over the
/// rows' names; without, conditions are called 1, 2, 3, ...
/// Errors: `name:line: ...` for another number of columns than rows, names that differ, a count
/// that is none, votes on the diagonal.
Expected<VoteTable> read_count_matrix(std::string_view text, const std::string& name);

/// A row per observer: N times N counts, column by column; element (i, j) is i over j.
Expected<VoteTable> read_observer_matrices(std::string_view text, const std::string& name);

} // namespace analysis::formats
