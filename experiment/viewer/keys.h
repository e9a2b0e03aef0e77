// The keyboard: one table that the window obeys, the help shows and docs/view.md repeats.
#pragma once

#include "experiment/viewer/viewer_state.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace experiment::viewer {

struct KeyRow {
    std::string keys; ///< as people read them
    std::string does;
    std::vector<std::pair<std::string, Input>> strokes; ///< "Left", "Shift+Left", "S", "Esc", ...
};

/// In the order people read them.
std::span<const KeyRow> key_table();

/// What a stroke does; nothing for one that is in no row.
std::optional<Input> input_of(std::string_view stroke);

} // namespace experiment::viewer
