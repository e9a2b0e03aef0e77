// Likelihood ratios, Wald tests, and errors that hold when observers differ.
#include "analysis/scaling/choice_tests.h"

#include "analysis/scaling/bradley_terry.h"
#include "analysis/scaling/fit_choices.h"
#include "analysis/scaling/thurstone.h"
#include "protocols/contract.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace analysis::scaling {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

bool is_maximum(const ChoiceFit& fit) {
    return fit.estimate == Estimate::MaximumLikelihood;
}

ChiSquaredTest chi_squared_test(double statistic, double df) {
    if (!(df > 0) || std::isnan(statistic))
        return {statistic, df, {nothing, nothing}};
    return {statistic, df, numerics::chi_squared_upper_tail(statistic, df)};
}

ChoiceFit fit(const WinCounts& counts, Link link) {
    return link == Link::Logit ? fit_bradley_terry(counts) : fit_thurstone(counts);
}

// Gradient of the log-likelihood of some votes at the fitted scores.
std::vector<double> score(const WinCounts& counts, const std::vector<double>& theta, Link link) {
    ChoiceModel model(counts.conditions, comparisons_of(counts), {.link = link});
    ModelPoint point;
    model.evaluate(theta, point);
    return point.gradient;
}

} // namespace

ChiSquaredTest equality_test(const WinCounts& counts, const ChoiceFit& fit) {
    EXPECTS(fit.conditions() == counts.conditions);
    double votes = 0;
    for (const auto& pair : comparisons_of(counts))
        votes += pair.first_wins + pair.second_wins;
    const double ratio = 2 * (fit.log_likelihood + votes * std::numbers::ln2);
    return chi_squared_test(is_maximum(fit) ? ratio : nothing,
                            static_cast<double>(fit.conditions()) - 1);
}

ChiSquaredTest likelihood_ratio_test(const ChoiceFit& smaller, const ChoiceFit& larger, double df) {
    const double ratio = 2 * (larger.log_likelihood - smaller.log_likelihood);
    return chi_squared_test(is_maximum(smaller) && is_maximum(larger) ? ratio : nothing, df);
}

GoodnessOfFit goodness_of_fit(const WinCounts& counts, const ChoiceFit& fit, Link link) {
    EXPECTS(fit.conditions() == counts.conditions);
    double g2 = 0, x2 = 0, df = 1 - static_cast<double>(fit.conditions());
    for (const auto& pair : comparisons_of(counts)) {
        const double d = fit.theta[pair.first] - fit.theta[pair.second];
        const double n = pair.first_wins + pair.second_wins;
        const double p = choice_probability(link, d), q = choice_probability(link, -d);
        if (pair.first_wins > 0)
            g2 += 2 * pair.first_wins * std::log(pair.first_wins / (n * p));
        if (pair.second_wins > 0)
            g2 += 2 * pair.second_wins * std::log(pair.second_wins / (n * q));
        const double residual = pair.first_wins * q - pair.second_wins * p;
        x2 += residual * residual / (n * p * q);
        df += 1;
    }
    const bool usable = is_maximum(fit);
    return {chi_squared_test(usable ? g2 : nothing, df),
            chi_squared_test(usable ? x2 : nothing, df)};
}

ChiSquaredTest heterogeneity_test(std::span<const WinCounts> parts, Link link) {
    EXPECTS(!parts.empty());
    const std::size_t t = parts[0].conditions;
    std::vector<std::int64_t> sum(t * t, 0);
    double apart = 0;
    for (const auto& part : parts) {
        EXPECTS(part.conditions == t);
        for (std::size_t k = 0; k < t * t; ++k)
            sum[k] += part.wins[k];
        const auto own = fit(part, link);
        apart += is_maximum(own) ? own.log_likelihood : nothing;
    }
    const auto pooled = fit({t, sum}, link);
    const double df = static_cast<double>((parts.size() - 1) * (t - 1));
    return chi_squared_test(is_maximum(pooled) ? 2 * (apart - pooled.log_likelihood) : nothing, df);
}

std::vector<WaldPair> wald_pairs(const ChoiceFit& fit) {
    std::vector<WaldPair> pairs;
    for (std::size_t a = 0; a < fit.conditions(); ++a)
        for (std::size_t b = a + 1; b < fit.conditions(); ++b) {
            const double difference = fit.theta[a] - fit.theta[b];
            const double error = difference_standard_error(fit, a, b);
            const double z = difference / error;
            pairs.push_back({a, b, difference, error, z, numerics::t_two_sided(z, HUGE_VAL)});
        }
    return pairs;
}

std::vector<double> cluster_robust_covariance(const ChoiceFit& fit,
                                              std::span<const WinCounts> observers,
                                              Link link,
                                              SmallSample correction) {
    const std::size_t t = fit.conditions();
    if (!is_maximum(fit) || observers.size() < 2)
        return std::vector<double>(t * t, nothing);
    std::vector<double> result(t * t, 0.0), influence(t);
    for (const auto& observer : observers) {
        EXPECTS(observer.conditions == t);
        const auto gradient = score(observer, fit.theta, link);
        for (std::size_t i = 0; i < t; ++i) {
            influence[i] = 0;
            for (std::size_t j = 0; j < t; ++j)
                influence[i] += fit.covariance[i * t + j] * gradient[j];
        }
        for (std::size_t i = 0; i < t; ++i)
            for (std::size_t j = 0; j < t; ++j)
                result[i * t + j] += influence[i] * influence[j];
    }
    const auto n = static_cast<double>(observers.size());
    if (correction == SmallSample::Corrected)
        for (double& value : result)
            value *= n / (n - 1);
    return result;
}

} // namespace analysis::scaling
