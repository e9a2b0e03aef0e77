// Every question a study asks: two conditions at one picture, in no particular order of sides.
#pragma once

#include "protocols/study.h"

#include <vector>

namespace protocols {

/// Indices into the study's scenes, its `shown_variants` and its conditions; `first < second`.
struct Question {
    int scene = 0;
    int variant = 0;
    int first = 0;
    int second = 0;
};

/// All pairs of conditions at all pictures, each once, in the order of the study file; the
/// reference is in none of them.
std::vector<Question> all_questions(const Study& study);

/// The question with its first condition on `side_of_first`.
Trial trial(const Study& study, const Question& question, Side side_of_first);

} // namespace protocols
