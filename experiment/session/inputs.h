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
    Left,    ///< the left picture: left arrow, or a click on it
    Right,   ///< the right picture
    Forward, ///< the next page: Space or Enter
    Release, ///< the experimenter's key: F9
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

/// The pictures that were asked for are on the screen since this input's time.
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

struct Input {
    Monotonic at{};
    std::variant<Pressed, LetGo, OnsetSeen, VoteStored, Waited, FocusLost, CloseAsked> what;
};

} // namespace experiment::session
