// Random orders of labelled items without equal neighbours, or with as few as there must be.
//
// Plain shuffles almost never succeed (1.4 in 10^9 for three scenes of 18 trials) and repairing one
// favours some orders over others, so orders are counted and one is drawn by its number: each is
// exactly equally likely.  Labels are small integers; the caller decides what they stand for.
#pragma once

#include "protocols/random.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace protocols {

/// How many sequences hold label i exactly `counts[i]` times and have exactly `equal_neighbours`
/// places where a label follows itself.  In decimal digits, because it outgrows every machine
/// integer: 54 trials of three scenes already make 1197390368733804.
/// `after`: the label of what was shown just before; following it with itself counts as well.
/// Errors: EXPECTS no negative count, and `after` among the labels.
std::string count_sequences(std::span<const int> counts,
                            int equal_neighbours = 0,
                            std::optional<int> after = {});

/// The least number of equal neighbours any sequence has: 0 unless one label has more than half of
/// the places.
int least_equal_neighbours(std::span<const int> counts, std::optional<int> after = {});

/// One of the sequences with `least_equal_neighbours`, all equally likely.
std::vector<int>
draw_sequence(std::span<const int> counts, Rng& rng, std::optional<int> after = {});

} // namespace protocols
