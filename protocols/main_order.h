// The order of the main trials: scenes kept apart, and a repeated question kept from returning
// soon.
#pragma once

#include "protocols/questions.h"
#include "protocols/random.h"

#include <cstddef>
#include <span>
#include <vector>

namespace protocols {

/// A question returns after more than this many trials, where that is possible.
inline constexpr int repeat_gap = 3;

struct MainOrder {
    std::vector<std::size_t> questions; ///< by index; each as often as it is asked
    int equal_neighbours = 0;           ///< neighbours that share a scene: the least possible
    int close_repeats = 0;              ///< questions that return within `repeat_gap` trials
};

/// An order in which each question is asked `repetitions` times.  Asked once each, every order with
/// the least number of equal neighbours is equally likely.  Asked more often, the scenes still are;
/// the questions are dealt to them anew until none returns too soon.
/// Errors: EXPECTS(repetitions > 0).
MainOrder draw_main_order(std::span<const Question> questions, int repetitions, Rng& rng);

} // namespace protocols
