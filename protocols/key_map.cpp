// Keys by name.
#include "protocols/key_map.h"

namespace protocols {

namespace {

struct Spelling {
    Action action;
    const char* name;
    std::vector<std::string> standard;
};

const std::vector<Spelling>& spellings() {
    static const std::vector<Spelling> list{
        {Action::Left, "left", {"Left"}},
        {Action::Right, "right", {"Right"}},
        {Action::NotSure, "not_sure", {"Down"}},
        {Action::MuchWorse, "much_worse", {"1", "KP_1"}},
        {Action::Worse, "worse", {"2", "KP_2"}},
        {Action::SlightlyWorse, "slightly_worse", {"3", "KP_3"}},
        {Action::Same, "same", {"4", "KP_4"}},
        {Action::SlightlyBetter, "slightly_better", {"5", "KP_5"}},
        {Action::Better, "better", {"6", "KP_6"}},
        {Action::MuchBetter, "much_better", {"7", "KP_7"}},
        {Action::Flip, "flip", {"Tab"}},
        {Action::Forward, "forward", {"Space", "Enter", "KP_Enter"}},
        {Action::Release, "release", {"F9"}},
        {Action::Again, "again", {"F8"}},
        {Action::Stop, "stop", {"Escape"}}};
    return list;
}

} // namespace

KeyMap standard_keys() {
    KeyMap keys;
    for (const auto& spelling : spellings())
        keys[spelling.action] = spelling.standard;
    return keys;
}

std::string name_of(Action action) {
    return spellings()[static_cast<std::size_t>(action)].name;
}

const std::vector<Action>& all_actions() {
    static const auto actions = [] {
        std::vector<Action> all;
        for (const auto& spelling : spellings())
            all.push_back(spelling.action);
        return all;
    }();
    return actions;
}

const std::vector<std::string>& key_names() {
    static const auto names = [] {
        std::vector<std::string> all{"Left",     "Right",  "Up",         "Down",   "Space",
                                     "Enter",    "Escape", "Tab",        "Delete", "Backspace",
                                     "Insert",   "Home",   "End",        "PageUp", "PageDown",
                                     "KP_Enter", "KP_Add", "KP_Subtract"};
        for (char letter = 'A'; letter <= 'Z'; ++letter)
            all.emplace_back(1, letter);
        for (char digit = '0'; digit <= '9'; ++digit) {
            all.emplace_back(1, digit);
            all.push_back(std::string("KP_") + digit);
        }
        for (int number = 1; number <= 12; ++number)
            all.push_back("F" + std::to_string(number));
        return all;
    }();
    return names;
}

} // namespace protocols
