// The words of the pages that are not the study's own, in the languages the program speaks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace experiment::session {

/// Sentences of the built-in pages.  {} stands for what is filled in.
struct Words {
    std::string_view language; ///< "en", "de"
    std::string_view next_page;
    std::string_view questions_heading, questions_ask, questions_task, questions_adapt;
    std::string_view answer_left, answer_right, answer_first, answer_second, answer_not_sure;
    std::string_view flip;
    std::string_view grades_of_right, grades_of_second;
    std::string_view grades[7];
    std::string_view questions_keys, training_again_key;
    std::string_view break_heading, break_text, break_keys;
    std::string_view paused_heading, paused_left, paused_changed, paused_keys;
    std::string_view stop_heading, stop_text, stop_keys;
    std::string_view limit_heading, limit_text, limit_keys;
    std::string_view thanks_heading, thanks_text, thanks_keys;
    std::string_view display_heading, display_keys;
    std::string_view contrast_heading, contrast_text, contrast_keys;
    std::string_view patch_keys;
};

/// Those of a language such as "de" or "de-AT"; English where the program does not speak it.
const Words& words_in(std::string_view language);

/// A key's name as people say it: "Space", "Leertaste"; letters and digits as they are.
std::string spoken_key(std::string_view name, const Words& words);

/// Whether the built-in pages are in this language, too.
bool speaks(std::string_view language);

/// "en", "de"
std::vector<std::string> spoken_languages();

} // namespace experiment::session
