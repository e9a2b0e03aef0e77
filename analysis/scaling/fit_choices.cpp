// Estimates name what they are; scores of data without a scale are NaN, never a large number.
#include "analysis/scaling/fit_choices.h"

#include "protocols/contract.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace analysis::scaling {

std::vector<Comparison> comparisons_of(const WinCounts& counts) {
    const std::size_t t = counts.conditions;
    EXPECTS(t > 0 && counts.wins.size() == t * t);
    std::vector<Comparison> pairs;
    for (std::size_t i = 0; i < t; ++i)
        for (std::size_t j = i + 1; j < t; ++j) {
            EXPECTS(counts(i, j) >= 0 && counts(j, i) >= 0);
            if (counts(i, j) + counts(j, i) > 0)
                pairs.push_back({i, j, static_cast<double>(counts(i, j)),
                                 static_cast<double>(counts(j, i)), 0});
        }
    return pairs;
}

std::vector<Comparison> comparisons_of(const OrderedCounts& counts) {
    const std::size_t t = counts.conditions;
    EXPECTS(t > 0 && counts.first_chosen.size() == t * t && counts.second_chosen.size() == t * t);
    EXPECTS(counts.tied.empty() || counts.tied.size() == t * t);
    std::vector<Comparison> pairs;
    for (std::size_t i = 0; i < t; ++i)
        for (std::size_t j = 0; j < t; ++j) {
            const std::size_t at = i * t + j;
            const std::int64_t ties = counts.tied.empty() ? 0 : counts.tied[at];
            const std::int64_t first = counts.first_chosen[at], second = counts.second_chosen[at];
            EXPECTS(first >= 0 && second >= 0 && ties >= 0);
            if (i != j && first + second + ties > 0)
                pairs.push_back({i, j, static_cast<double>(first), static_cast<double>(second),
                                 static_cast<double>(ties)});
        }
    return pairs;
}

ChoiceFit no_scale(std::size_t conditions, Existence found, std::string reason) {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    ChoiceFit fit;
    fit.reason = std::move(reason);
    fit.theta.assign(conditions, nothing);
    fit.covariance.assign(conditions * conditions, nothing);
    fit.log_likelihood = nothing;
    fit.existence = std::move(found);
    return fit;
}

ChoiceFit fit_choices(std::size_t conditions,
                      std::vector<Comparison> comparisons,
                      ModelTerms terms,
                      Existence found) {
    const std::size_t t = conditions;
    ChoiceModel model(t, std::move(comparisons), terms);
    const auto maximum = model.maximise();
    if (!maximum.converged)
        return no_scale(t, std::move(found),
                        fmt::format("no finite maximum of the likelihood after {} Newton steps",
                                    maximum.iterations));
    ChoiceFit fit;
    fit.estimate = terms.firth       ? Estimate::Firth
                   : terms.ridge > 0 ? Estimate::Ridge
                                     : Estimate::MaximumLikelihood;
    fit.theta.assign(maximum.parameters.begin(),
                     maximum.parameters.begin() + static_cast<std::ptrdiff_t>(t));
    fit.log_likelihood = maximum.log_likelihood;
    fit.iterations = maximum.iterations;
    fit.converged = true;
    fit.existence = std::move(found);
    const auto covariance = model.covariance(maximum.parameters);
    const std::size_t p = model.parameters();
    for (std::size_t i = 0; i < t; ++i)
        for (std::size_t j = 0; j < t; ++j)
            fit.covariance.push_back(covariance[i * p + j]);
    const auto nuisance = [&](std::size_t at) {
        return Nuisance{maximum.parameters[at], std::sqrt(covariance[at * p + at])};
    };
    if (terms.side)
        fit.side = nuisance(t);
    if (terms.ties)
        fit.log_nu = nuisance(p - 1);
    return fit;
}

std::string describe(const Existence& found) {
    std::string text;
    for (const auto& component : found.components) {
        if (!text.empty())
            text += found.scale == Scale::Disconnected ? " apart from " : " above ";
        text += fmt::format("{{{}}}", fmt::join(component, ", "));
    }
    return text;
}

} // namespace analysis::scaling
