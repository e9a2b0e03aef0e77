// What an observer can see during a sitting.
#pragma once

#include "experiment/session/inputs.h"
#include "protocols/schedule.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace experiment::session {

/// A rectangle of one code value, in shares of the screen's width and height from its upper left.
struct Patch {
    double left = 0, top = 0, width = 0, height = 0;
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Patch&) const = default;
};

/// A page of text on the surround's grey.
struct PageView {
    std::string text;             ///< UTF-8; lines that begin with "# " are headings
    std::string keys;             ///< what can be pressed, in words
    Key advance = Key::Forward;   ///< the key that leads on
    std::vector<Patch> patches{}; ///< below the text, the later over the earlier
    bool operator==(const PageView&) const = default;
};

/// The surround's grey over the whole screen.
struct GreyView {
    bool operator==(const GreyView&) const = default;
};

/// Which pictures of a trial are on the screen.  The first is the one that the plan calls left.
enum class Part { Both, First, Second };

/// The pictures of a trial.
struct PairView {
    int number = 0; ///< of the trial in the plan
    protocols::Trial trial;
    Part part = Part::Both;
    bool operator==(const PairView&) const = default;
};

/// The sitting is over: finished, or stopped and to be resumed.
struct EndView {
    bool finished = false;
    bool operator==(const EndView&) const = default;
};

using View = std::variant<PageView, GreyView, PairView, EndView>;

} // namespace experiment::session
