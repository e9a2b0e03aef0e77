// What an observer can see during a sitting.
#pragma once

#include "experiment/session/inputs.h"
#include "protocols/schedule.h"

#include <string>
#include <variant>

namespace experiment::session {

/// A page of text on the surround's grey.
struct PageView {
    std::string text;           ///< UTF-8; lines that begin with "# " are headings
    std::string keys;           ///< what can be pressed, in words
    Key advance = Key::Forward; ///< the key that leads on
    bool operator==(const PageView&) const = default;
};

/// The surround's grey over the whole screen.
struct GreyView {
    bool operator==(const GreyView&) const = default;
};

/// Both pictures of a trial.
struct PairView {
    int number = 0; ///< of the trial in the plan
    protocols::Trial trial;
    bool operator==(const PairView&) const = default;
};

/// The sitting is over: finished, or stopped and to be resumed.
struct EndView {
    bool finished = false;
    bool operator==(const EndView&) const = default;
};

using View = std::variant<PageView, GreyView, PairView, EndView>;

} // namespace experiment::session
