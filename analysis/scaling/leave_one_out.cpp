// The same log-likelihood has an expectation and a variance under the others' fit: a z score.
#include "analysis/scaling/leave_one_out.h"

#include "analysis/scaling/bradley_terry.h"
#include "analysis/scaling/fit_choices.h"
#include "analysis/scaling/thurstone.h"
#include "protocols/contract.h"

#include <cmath>

namespace analysis::scaling {
namespace {

constexpr double own_lambda = 0.1; // one person's votes are few: unanimous pairs are the rule

void foretell(LeftOut& left, const WinCounts& own, Link link) {
    double votes = 0;
    for (const auto& pair : comparisons_of(own)) {
        const double d = left.others.theta[pair.first] - left.others.theta[pair.second];
        const double n = pair.first_wins + pair.second_wins;
        const auto log_p = [&](double at) {
            return link == Link::Logit ? logit_term(at, 1, 0).log_likelihood
                                       : probit_term(at, 1, 0).log_likelihood;
        };
        const double win = log_p(d), lose = log_p(-d), p = std::exp(win), q = std::exp(lose);
        left.log_likelihood += pair.first_wins * win + pair.second_wins * lose;
        left.expected += n * (p * win + q * lose);
        left.variance += n * p * q * (win - lose) * (win - lose);
        votes += n;
    }
    left.log_likelihood_per_vote = left.log_likelihood / votes;
    left.z = (left.log_likelihood - left.expected) / std::sqrt(left.variance);
}

} // namespace

std::vector<LeftOut> leave_one_out(std::span<const WinCounts> observers, Link link) {
    EXPECTS(observers.size() >= 2);
    const std::size_t t = observers[0].conditions;
    std::vector<std::int64_t> sum(t * t, 0), others(t * t);
    for (const auto& observer : observers) {
        EXPECTS(observer.conditions == t && observer.wins.size() == t * t);
        for (std::size_t k = 0; k < t * t; ++k)
            sum[k] += observer.wins[k];
    }
    std::vector<LeftOut> result;
    for (const auto& observer : observers) {
        for (std::size_t k = 0; k < t * t; ++k)
            others[k] = sum[k] - observer.wins[k];
        const WinCounts rest{t, others};
        auto& left = result.emplace_back();
        left.others = link == Link::Logit ? fit_bradley_terry(rest) : fit_thurstone(rest);
        foretell(left, observer, link);
        left.own_theta = (link == Link::Logit ? fit_bradley_terry_ridge(observer, own_lambda)
                                              : fit_thurstone_ridge(observer, own_lambda))
                             .theta;
    }
    return result;
}

} // namespace analysis::scaling
