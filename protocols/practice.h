// Trials before the main ones: training and warm-ups, drawn from the session's own questions.
#pragma once

#include "protocols/questions.h"
#include "protocols/random.h"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace protocols {

/// Which questions may stand at a place of the practice, counted from 0.
using Wanted = std::map<int, std::function<bool(const Question&)>>;

/// `count` questions out of `pool` (indices into `questions`), in the order they are shown, none
/// more than once unless the pool is too small.  No two neighbours share a scene, and the last does
/// not show `next_scene`, whenever the pool permits that; at the places of `wanted`, such questions
/// as are wanted there, whenever the pool has some that keep the rule.
/// Errors: EXPECTS a pool that is not empty, unless count is 0.
std::vector<std::size_t> draw_practice(std::span<const Question> questions,
                                       std::span<const std::size_t> pool,
                                       int count,
                                       std::optional<int> next_scene,
                                       Rng& rng,
                                       const Wanted& wanted = {});

} // namespace protocols
