// Which of n things hang together: sets that are joined, never parted.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace renderer::geometry {

/// Union by the smaller index, so that a set is named by its smallest member in whatever order the
/// joins come; paths are halved on the way.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    /// Smallest member of the set that `i` is in.
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        parent_[a < b ? b : a] = a < b ? a : b;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

} // namespace renderer::geometry
