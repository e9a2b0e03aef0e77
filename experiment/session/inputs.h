// What can happen during a sitting, each with the time it happened.
#pragma once

#include <chrono>
#include <string>
#include <variant>

namespace experiment::session {

/// A time on the monotonic clock, since an epoch of its own.
using Monotonic = std::chrono::nanoseconds;

/// What a key or a mouse button means here; which one it was is the screen's business.
enum class Key {
    Left,      ///< the left picture, or the first: an arrow, or a click on it
    Right,     ///< the right picture, or the second
    NotSure,   ///< neither
    MuchWorse, ///< seven grades of the right picture, or the second, compared with the other
    Worse,
    SlightlyWorse,
    Same,
    SlightlyBetter,
    Better,
    MuchBetter,
    Flip,    ///< the other picture, where they are seen in turn
    Forward, ///< the next page
    Release, ///< the experimenter's key
    Again,   ///< the experimenter's: the training once more
    Escape,
    Other
};

enum class Device { Keyboard, Mouse, Simulated };

struct Pressed {
    Key key{};
    Device device{};
    bool repeated = false; ///< the keyboard's own repetition of a key that is held
};

struct LetGo {
    Key key{};
};

/// The view that was asked for is on the screen since this input's time.
struct OnsetSeen {
    std::string source; ///< how that is known: "swap_return", "virtual"
};

/// The vote that was to be recorded is on the disk.
struct VoteStored {};

/// Time went by.
struct Waited {};

/// The window lost the keyboard.
struct FocusLost {};

/// Somebody closed the window.
struct CloseAsked {};

/// The screen is not what it was: another size, a monitor gone or come.
struct DisplayChanged {
    std::string what; ///< "the window has 800 x 600 pixels, not 1280 x 800"
};

struct Input {
    Monotonic at{};
    std::variant<Pressed,
                 LetGo,
                 OnsetSeen,
                 VoteStored,
                 Waited,
                 FocusLost,
                 CloseAsked,
                 DisplayChanged>
        what;
};

} // namespace experiment::session
