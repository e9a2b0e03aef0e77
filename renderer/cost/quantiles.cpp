// Between order statistics by proportion.
#include "renderer/cost/quantiles.h"

#include "renderer/contract.h"

#include <algorithm>
#include <cstddef>

namespace renderer::cost {

double quantile(std::vector<double> values, double q) {
    EXPECTS(!values.empty() && q >= 0 && q <= 1);
    std::sort(values.begin(), values.end());
    const double place = q * static_cast<double>(values.size() - 1);
    const auto i = static_cast<std::size_t>(place);
    const double rest = place - static_cast<double>(i);
    return i + 1 < values.size() ? values[i] * (1 - rest) + values[i + 1] * rest : values[i];
}

Spread spread_of(const std::vector<double>& values) {
    return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}

std::vector<double> ratios(std::span<const double> values, std::span<const double> base) {
    std::vector<double> result;
    for (std::size_t i = 0; i < std::min(values.size(), base.size()); ++i)
        result.push_back(values[i] / base[i]);
    return result;
}

} // namespace renderer::cost
