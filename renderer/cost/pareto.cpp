// Along growing cost, whatever has the least error so far is on the front.
#include "renderer/cost/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace renderer::cost {

std::vector<std::size_t> pareto_front(std::span<const Tradeoff> settings) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (!std::isnan(settings[i].cost) && !std::isnan(settings[i].error))
            order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return settings[a].cost != settings[b].cost ? settings[a].cost < settings[b].cost
                                                    : settings[a].error < settings[b].error;
    });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const auto i : order)
        if (front.empty() || settings[i].error < least) {
            front.push_back(i);
            least = settings[i].error;
        }
    return front;
}

} // namespace renderer::cost
