// Separable filtering.
#include "renderer/imaging/plane.h"

#include "renderer/contract.h"

#include <algorithm>

namespace renderer::imaging {

Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down) {
    EXPECTS(across.size() % 2 == 1 && down.size() % 2 == 1);
    const int rx = static_cast<int>(across.size() / 2), ry = static_cast<int>(down.size() / 2);
    Plane rows(plane.width, plane.height), result(plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) {
            double sum = 0;
            for (int i = -rx; i <= rx; ++i)
                sum += static_cast<double>(across[static_cast<std::size_t>(i + rx)]) *
                       static_cast<double>(plane.at(std::clamp(x + i, 0, plane.width - 1), y));
            rows.at(x, y) = static_cast<float>(sum);
        }
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) {
            double sum = 0;
            for (int i = -ry; i <= ry; ++i)
                sum += static_cast<double>(down[static_cast<std::size_t>(i + ry)]) *
                       static_cast<double>(rows.at(x, std::clamp(y + i, 0, plane.height - 1)));
            result.at(x, y) = static_cast<float>(sum);
        }
    return result;
}

} // namespace renderer::imaging
