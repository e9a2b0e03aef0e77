// Keys by name, as GLFW numbers them.
#define GLFW_INCLUDE_NONE
#include "experiment/session/glfw_keys.h"

#include "protocols/contract.h"

#include <GLFW/glfw3.h>

#include <string>

namespace experiment::session {

namespace {

using protocols::Action;

const std::map<std::string, int>& named_codes() {
    static const std::map<std::string, int> codes{{"Left", GLFW_KEY_LEFT},
                                                  {"Right", GLFW_KEY_RIGHT},
                                                  {"Up", GLFW_KEY_UP},
                                                  {"Down", GLFW_KEY_DOWN},
                                                  {"Space", GLFW_KEY_SPACE},
                                                  {"Enter", GLFW_KEY_ENTER},
                                                  {"Escape", GLFW_KEY_ESCAPE},
                                                  {"Tab", GLFW_KEY_TAB},
                                                  {"Delete", GLFW_KEY_DELETE},
                                                  {"Backspace", GLFW_KEY_BACKSPACE},
                                                  {"Insert", GLFW_KEY_INSERT},
                                                  {"Home", GLFW_KEY_HOME},
                                                  {"End", GLFW_KEY_END},
                                                  {"PageUp", GLFW_KEY_PAGE_UP},
                                                  {"PageDown", GLFW_KEY_PAGE_DOWN},
                                                  {"KP_Enter", GLFW_KEY_KP_ENTER},
                                                  {"KP_Add", GLFW_KEY_KP_ADD},
                                                  {"KP_Subtract", GLFW_KEY_KP_SUBTRACT}};
    return codes;
}

// Letters and digits have their ASCII codes, the rest lies in rows.
int code_of(const std::string& name) {
    if (const auto found = named_codes().find(name); found != named_codes().end())
        return found->second;
    if (name.size() == 1)
        return name[0];
    if (name.starts_with("KP_"))
        return GLFW_KEY_KP_0 + (name[3] - '0');
    EXPECTS(name.starts_with("F"));
    return GLFW_KEY_F1 + std::stoi(name.substr(1)) - 1;
}

Key key_of(Action action) {
    switch (action) {
    case Action::Left:
        return Key::Left;
    case Action::Right:
        return Key::Right;
    case Action::NotSure:
        return Key::NotSure;
    case Action::Flip:
        return Key::Flip;
    case Action::Forward:
        return Key::Forward;
    case Action::Release:
        return Key::Release;
    case Action::Again:
        return Key::Again;
    case Action::Stop:
        return Key::Escape;
    default: // the grades lie in the same order in both
        return static_cast<Key>(static_cast<int>(Key::MuchWorse) + static_cast<int>(action) -
                                static_cast<int>(Action::MuchWorse));
    }
}

} // namespace

std::map<int, Key> glfw_keys(const protocols::KeyMap& keys) {
    std::map<int, Key> codes;
    for (const auto& [action, names] : keys)
        for (const auto& name : names)
            codes[code_of(name)] = key_of(action);
    return codes;
}

} // namespace experiment::session
