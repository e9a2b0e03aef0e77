// Votes from the files of other programs.  Which is which shows in the file, or is said.
#pragma once

#include "analysis/vote_table.h"

#include <string>
#include <string_view>

namespace analysis::formats {

enum class VoteFormat {
    Detect,
    Long,             ///< a row per vote: the program's own table, pwcmp's, QuickEval's
    Pairs,            ///< winner, loser[, votes] (choix), or player1, player2, win1, win2[, ties]
    Matrix,           ///< square, row chosen over column (eba, ASAP), with or without names
    ObserverMatrices, ///< a row per observer of N N counts, column-major: i over j (pwcmp)
    Wide,             ///< columns A:B with 1 for the first, 0 for the second
    PairedComparison, ///< columns 1:2, 1:3, 2:3 .. (psychotools) or V12, V13, V23 .. (prefmod):
                      ///< 1 for the first, -1 for the second, 0 undecided
    Sureal            ///< JSON or a script with `dis_videos`, each with (subject, loser): 1
};

/// Everything a file says of votes, as a table.  Counts become as many votes; whoever gave them is
/// one observer where the file does not say.  Sides are not known where only the two are named, and
/// a note says so.
/// Errors: `name:line: ...`, and a file whose format does not show, with what to say; names that
/// differ only in blanks around them.
Expected<VoteTable> read_vote_file(std::string_view text,
                                   const std::string& name,
                                   VoteFormat format = VoteFormat::Detect,
                                   Repeats repeats = Repeats::Refuse);

} // namespace analysis::formats
