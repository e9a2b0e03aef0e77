// Boxes of numbers with an axis for every factor, the last running fastest.
#pragma once

#include <cstddef>
#include <span>

namespace analysis::anova {

/// How far neighbours along `axis` lie apart.
constexpr std::size_t stride(std::span<const std::size_t> sizes, std::size_t axis) {
    std::size_t inner = 1;
    for (const auto size : sizes.subspan(axis + 1))
        inner *= size;
    return inner;
}

} // namespace analysis::anova
