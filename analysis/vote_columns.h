// What the columns of a table of votes mean, by the names in its header row: the program's own, and
// those of the field.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace analysis {

/// How a row says what was chosen.
enum class AnswerForm {
    Side,        ///< left, right, tie
    FirstChosen, ///< 1 when the first named was chosen, 0 when the second
    FirstSecond, ///< 1 or 2
    Name         ///< the name of the chosen condition
};

/// Places of columns; -1 where the table has none.
struct VoteColumns {
    int study = -1, observer = -1, session = -1, trial = -1, left = -1, right = -1, answer = -1,
        milliseconds = -1, seconds = -1, phase = -1, counted = -1, simulated = -1;
    AnswerForm form = AnswerForm::Side;
    bool sides_known = true; ///< false where conditions are named first and second, not left, right
    std::vector<std::size_t> factors;
    std::vector<std::string> factor_names;
    std::vector<std::string> left_out; ///< columns that are not read
    std::size_t count = 0;
};

/// "" or what is wrong with the header.
std::string read_vote_columns(std::span<const std::string_view> header, VoteColumns& columns);

} // namespace analysis
