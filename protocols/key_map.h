// Which key of a keyboard, or of a box that types keys, means what.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace protocols {

/// What a key can mean in a sitting.
enum class Action {
    Left,
    Right,
    NotSure,
    MuchWorse, ///< grades say it of the right picture, compared with the left one
    Worse,
    SlightlyWorse,
    Same,
    SlightlyBetter,
    Better,
    MuchBetter,
    Flip,    ///< the other picture, where pictures take turns at the observer's wish
    Forward, ///< the next page
    Release, ///< the experimenter: begin, or go on
    Again,   ///< the experimenter: the training once more
    Stop
};

/// Names of keys for each action.
using KeyMap = std::map<Action, std::vector<std::string>>;

/// Left and right arrow, Down for "not sure", 1 to 7 for grades, Tab, Space or Enter, F9, F8,
/// Escape.
KeyMap standard_keys();

/// How a study file spells it: "left", "not_sure", "much_worse", ...
std::string name_of(Action action);

/// All of them.
const std::vector<Action>& all_actions();

/// The names that keys may have: letters and digits as printed on a keyboard of the United States,
/// "Left", "Space", "F1", "KP_1", ...
const std::vector<std::string>& key_names();

} // namespace protocols
