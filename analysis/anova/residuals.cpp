#include "analysis/anova/residuals.h"

#include "analysis/exact.h"
#include "protocols/contract.h"

namespace analysis::anova {

WithinResiduals
within_residuals(std::span<const std::int64_t> counts, std::size_t levels, std::int64_t divisor) {
    EXPECTS(levels >= 2 && counts.size() >= 2 * levels && counts.size() % levels == 0);
    const auto n = counts.size() / levels;
    std::vector<Wide> by_level(levels, 0), by_observer(n, 0);
    Wide total = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        by_level[i % levels] += counts[i];
        by_observer[i / levels] += counts[i];
        total += counts[i];
    }
    const auto k = static_cast<Wide>(levels), observers = static_cast<Wide>(n);
    const double unit = static_cast<double>(k * observers) * static_cast<double>(divisor);
    WithinResiduals result;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const Wide fitted = k * by_level[i % levels] + observers * by_observer[i / levels] - total;
        const Wide score = k * observers * counts[i];
        result.fitted.push_back(static_cast<double>(fitted) / unit);
        result.residual.push_back(static_cast<double>(score - fitted) / unit);
    }
    result.normality = shapiro_wilk(result.residual);
    return result;
}

} // namespace analysis::anova
