// How long a sitting takes, before anyone has sat through it.
#pragma once

#include "protocols/study.h"

#include <chrono>

namespace protocols {

/// The planning value for one pair: looking, answering and the grey before the next.
inline constexpr std::chrono::seconds planned_pair_time{8};

/// BT.500: a session of at most half an hour.
inline constexpr std::chrono::minutes longest_session{30};

/// Training, warm-ups and main trials at `planned_pair_time`, and the adaptation before them. Pages
/// and breaks are not in it: they take as long as the observer wishes.
std::chrono::seconds estimated_length(const Study& study);

} // namespace protocols
