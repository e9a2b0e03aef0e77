// Votes from CSV text: the program's own long export, and the column names other tables use.
#pragma once

#include "analysis/vote_table.h"

#include <string>
#include <string_view>

namespace analysis {

/// Reads a table of votes, one per row, by the names in its header row.
///
/// Needed: `observer`, `left`, `right`, and `chosen` or `choice` (`left`, `right`, `tie`).
/// Known:  `study` (one per file), `session`, `trial`, `rt_ms`, `onset_utc`, `phase` (rows other
///         than `main` are counted and passed over), `simulated` (`0`, `1`, `false`, `true`).
/// Also known, as other programs name them: `participant_id`, `subject`, ... for the observer;
/// `session_id`; `condition_A`, `condition_B` for the two (which side is then not known);
/// `is_A_selected` (1, 0), `selection` (1, 2), `selected` (a name) or `response` (also `not_sure`,
/// a tie, and `none`, passed over) for the answer; `time_spent`, `response_time` in seconds.
/// Any other column that stands before `right` is a scene factor (`scene`, `variant`, `model`,
/// `light`, ...) unless it is empty in every row; other columns after it are left out, and a note
/// says so.
/// Errors: `name:line: ...` for a missing or doubled column, a row of another length, an empty
/// name, an unknown answer, a condition against itself, and a question answered twice by the same
/// observer in a session (unless `repeats` allows it).
Expected<VoteTable>
read_votes_csv(std::string_view text, const std::string& name, Repeats repeats = Repeats::Refuse);

} // namespace analysis
