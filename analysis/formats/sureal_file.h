// Paired comparisons as sureal keeps them: a JSON file or a Python script that holds `ref_videos`
// and `dis_videos`.
#pragma once

#include "analysis/vote_table.h"

#include <string>
#include <string_view>

namespace analysis::formats {

/// Each of `dis_videos` has an `asset_id`, a `content_id` and `os`, a map from (subject, asset) to
/// 1 (this one was chosen over that), 0 (the other was) or 0.5 (a tie).  JSON has no such keys, so
/// there they are texts: "('Ann', 2)" or "[\"Ann\", 2]".
/// Contents become levels of the scene factor `content`, and conditions are called by
/// `condition_names`.  What the form does not know and `sureal_script` says all the same is read:
/// `scene` of a reference, a level for every scene factor, `condition` of an asset, and
/// `simulated`.  Said twice, from both sides, a vote counts once.
/// Errors: `name:line: ...` for what is not of this form, an unknown asset, a pair across contents,
/// and two votes of one subject on one pair, of which the form knows only one.
Expected<VoteTable> read_sureal_data_set(std::string_view text, const std::string& name);

/// Whether a file's beginning is that of such a data set and not of a table.
bool looks_like_sureal(std::string_view text);

} // namespace analysis::formats
