// Expected mean squares: E MS(level) = s2_e + S s2_oa + N S s2_a, E MS(level x observer) = s2_e + S
// s2_oa, E MS(level x session within observers) = s2_e.
#include "analysis/anova/variance_components.h"

#include "analysis/anova/within_observers.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>

namespace analysis::anova {

VarianceComponents variance_components(std::span<const std::int64_t> counts,
                                       std::size_t observers,
                                       std::size_t sessions,
                                       std::size_t levels,
                                       std::int64_t divisor) {
    EXPECTS(counts.size() == observers * sessions * levels);
    VarianceComponents result;
    if (observers < 2 || sessions < 2 || levels < 2) {
        result.reason = "needs two observers, sessions and conditions";
        return result;
    }
    const auto analysis = within_observers_of_counts(
        observers, {{"session", sessions}, {"method", levels}}, counts, divisor);
    const auto& method = analysis.effects[1];
    const auto& session = analysis.effects[2]; // session x method
    const double n = static_cast<double>(observers), s = static_cast<double>(sessions);
    const double ms_a = method.effect.ms(), ms_oa = method.error.ms();
    const double ms_e =
        (session.effect.ss + session.error.ss) / (session.effect.df + session.error.df);
    result.repetition = ms_e;
    result.observer_x_condition = std::max(0.0, (ms_oa - ms_e) / s);
    result.condition = std::max(0.0, (ms_a - ms_oa) / (n * s));
    result.intra_observer_sd = std::sqrt(result.repetition);
    result.inter_observer_sd = std::sqrt(result.observer_x_condition);
    const double all =
        result.condition + result.observer_x_condition / n + result.repetition / (n * s);
    if (all > 0)
        result.reliability = result.condition / all;
    else
        result.reason = "0/0: nothing varies";
    return result;
}

} // namespace analysis::anova
