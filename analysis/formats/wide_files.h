// A row per observer (and session and scene), a column per pair.
#pragma once

#include "analysis/vote_table.h"

#include <span>
#include <string>
#include <string_view>

namespace analysis::formats {

/// What stands for the second of a pair: 0, and nothing for undecided; or -1, and 0 for undecided.
enum class SecondChosen { Zero, MinusOne };

/// Columns `A:B` (or `V12`: condition 1 against 2, one digit each) hold answers, empty or NA where
/// the pair was not asked; `observer`, `subject`, `participant` or `participant_id`, `session`
/// and `simulated` are known; other columns are scene factors.  Without an observer each row is
/// one. Errors: `name:line: ...` for an answer of another form, a header without pairs.
Expected<VoteTable>
read_wide_votes(std::string_view text, const std::string& name, SecondChosen second);

/// Whether a header has columns of pairs.
bool has_pair_columns(std::span<const std::string_view> header);

} // namespace analysis::formats
