// The probit twin of bradley_terry.cpp.
#include "analysis/scaling/thurstone.h"

#include "analysis/scaling/fit_choices.h"
#include "protocols/contract.h"

#include <utility>

namespace analysis::scaling {

ChoiceFit fit_thurstone(const WinCounts& counts) {
    auto found = existence(counts);
    if (found.scale == Scale::Disconnected) {
        auto reason = "no common scale: " + describe(found);
        return no_scale(counts.conditions, std::move(found), std::move(reason));
    }
    if (found.scale == Scale::Separated) {
        auto fit = fit_thurstone_ridge(counts, 1.0);
        fit.reason = "no finite maximum of the likelihood: " + describe(found) + "; ridge instead";
        return fit;
    }
    return fit_choices(counts.conditions, comparisons_of(counts), {.link = Link::Probit},
                       std::move(found));
}

ChoiceFit fit_thurstone_ridge(const WinCounts& counts, double lambda) {
    EXPECTS(lambda > 0);
    return fit_choices(counts.conditions, comparisons_of(counts),
                       {.link = Link::Probit, .ridge = lambda}, existence(counts));
}

ChoiceFit fit_thurstone_jod(const WinCounts& counts) {
    return in_unit(fit_thurstone(counts), jod_sigma);
}

} // namespace analysis::scaling
