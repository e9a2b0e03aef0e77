// Of many settings with a cost and an error, those worth having.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace renderer::cost {

struct Tradeoff {
    double cost = 0, error = 0; ///< less is better; NaN: not known, never worth having
};

/// Those that no other beats: whoever costs as little has a greater error.  By rising cost, so by
/// falling error; of equals the first.
std::vector<std::size_t> pareto_front(std::span<const Tradeoff> settings);

} // namespace renderer::cost
