// One number per pixel, and filters over it.
#pragma once

#include <cstddef>
#include <vector>

namespace renderer::imaging {

/// Row-major, top row first.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane() = default;

    Plane(int w, int h)
        : width(w), height(h),
          values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 0.0f) {}

    float& at(int x, int y) { return values[index(x, y)]; }

    float at(int x, int y) const { return values[index(x, y)]; }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

/// Weights for offsets -radius..radius: 2 radius + 1 of them.
using Kernel = std::vector<float>;

/// `across` along rows, then `down` along columns; beyond the edge the nearest pixel goes on.
/// Errors: EXPECTS kernels of odd length.
Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down);

} // namespace renderer::imaging
