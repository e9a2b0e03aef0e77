// Which picture stands on the left: every condition as often as on the right.
#pragma once

#include "protocols/random.h"
#include "protocols/vocabulary.h"

#include <span>
#include <vector>

namespace protocols {

/// Two conditions to be shown side by side at a scene; all are indices, 0...
struct Comparison {
    int scene = 0;
    int first = 0;
    int second = 0;
};

/// The side of each comparison's `first` condition.  Within every scene, and overall, each
/// condition is left in floor or ceil of half its comparisons.  Every single comparison falls
/// either way with chance one half.
/// Errors: EXPECTS no negative index, and `first` other than `second`.
std::vector<Side> draw_sides(std::span<const Comparison> comparisons, Rng& rng);

} // namespace protocols
