// Whether a maximum exists is decided before Newton's first step, by graphs and by difference
// constraints; iterations are never run to see whether they overflow.
#include "analysis/scaling/bradley_terry.h"

#include "analysis/scaling/fit_choices.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace analysis::scaling {
namespace {

// Votes with the order forgotten; a tie counts both ways, for it bounds both differences.
std::vector<std::int64_t> pooled(const OrderedCounts& counts) {
    const std::size_t t = counts.conditions;
    std::vector<std::int64_t> wins(t * t, 0);
    for (std::size_t i = 0; i < t; ++i)
        for (std::size_t j = 0; j < t; ++j) {
            const std::size_t at = i * t + j, mirrored = j * t + i;
            const std::int64_t ties = counts.tied.empty() ? 0 : counts.tied[at];
            wins[at] += counts.first_chosen[at] + ties;
            wins[mirrored] += counts.second_chosen[at] + ties;
        }
    return wins;
}

std::int64_t total(std::span<const std::int64_t> counts) {
    std::int64_t sum = 0;
    for (const std::int64_t count : counts)
        sum += count;
    return sum;
}

// theta_above - theta_below >= gap
struct Constraint {
    std::size_t above = 0, below = 0;
    double gap = 0;
};

// Difference constraints hold together unless some cycle of gaps is positive (Bellman and Ford).
bool feasible(std::size_t conditions, const std::vector<Constraint>& constraints) {
    std::vector<double> theta(conditions, 0.0);
    for (std::size_t sweep = 0; sweep <= conditions; ++sweep) {
        bool changed = false;
        for (const auto& [above, below, gap] : constraints)
            if (theta[above] < theta[below] + gap) {
                theta[above] = theta[below] + gap;
                changed = true;
            }
        if (!changed)
            return true;
    }
    return false;
}

// A scale under which theta_first - theta_second is 1 for every pair shown imitates a side effect.
bool side_confounded(std::size_t conditions, const std::vector<Comparison>& pairs) {
    std::vector<Constraint> exact;
    for (const auto& pair : pairs) {
        exact.push_back({pair.first, pair.second, 1});
        exact.push_back({pair.second, pair.first, -1});
    }
    return feasible(conditions, exact);
}

// The likelihood rises without end along side = +-1 when some scale agrees with every vote there.
bool side_separated(std::size_t conditions, const std::vector<Comparison>& pairs) {
    for (const double side : {1.0, -1.0}) {
        std::vector<Constraint> agree;
        for (const auto& pair : pairs) {
            if (pair.first_wins + pair.ties > 0)
                agree.push_back({pair.first, pair.second, -side});
            if (pair.second_wins + pair.ties > 0)
                agree.push_back({pair.second, pair.first, side});
        }
        if (feasible(conditions, agree))
            return true;
    }
    return false;
}

// It rises along ln nu = 1/2 when a scale puts every win at least 1 apart and every tie at most 1.
bool ties_separated(std::size_t conditions, const std::vector<Comparison>& pairs) {
    std::vector<Constraint> agree;
    for (const auto& pair : pairs) {
        if (pair.first_wins > 0)
            agree.push_back({pair.first, pair.second, 1});
        if (pair.second_wins > 0)
            agree.push_back({pair.second, pair.first, 1});
        if (pair.ties > 0) {
            agree.push_back({pair.first, pair.second, -1});
            agree.push_back({pair.second, pair.first, -1});
        }
    }
    return feasible(conditions, agree);
}

ChoiceFit infinite(std::size_t conditions, Existence found, const std::string& why) {
    return no_scale(conditions, std::move(found), "no finite maximum of the likelihood: " + why);
}

} // namespace

ChoiceFit fit_bradley_terry(const WinCounts& counts) {
    auto found = existence(counts);
    if (found.scale != Scale::Finite) {
        auto fit = fit_bradley_terry_firth(counts);
        if (fit.estimate == Estimate::Firth)
            fit.reason = "no finite maximum of the likelihood: " + describe(found) +
                         "; Firth's penalised estimate instead";
        return fit;
    }
    return fit_choices(counts.conditions, comparisons_of(counts), {}, std::move(found));
}

ChoiceFit fit_bradley_terry_firth(const WinCounts& counts) {
    auto found = existence(counts);
    if (found.scale == Scale::Disconnected) {
        auto reason = "no common scale: " + describe(found);
        return no_scale(counts.conditions, std::move(found), std::move(reason));
    }
    return fit_choices(counts.conditions, comparisons_of(counts), {.firth = true},
                       std::move(found));
}

ChoiceFit fit_bradley_terry_ridge(const WinCounts& counts, double lambda) {
    EXPECTS(lambda > 0);
    return fit_choices(counts.conditions, comparisons_of(counts), {.ridge = lambda},
                       existence(counts));
}

ChoiceFit fit_bradley_terry_sides(const OrderedCounts& counts) {
    const OrderedCounts decided{counts.conditions, counts.first_chosen, counts.second_chosen, {}};
    const auto pairs = comparisons_of(decided);
    const auto wins = pooled(decided);
    auto found = existence({counts.conditions, wins});
    if (found.scale == Scale::Disconnected) {
        auto reason = "no common scale: " + describe(found);
        return no_scale(counts.conditions, std::move(found), std::move(reason));
    }
    if (side_confounded(counts.conditions, pairs))
        return no_scale(counts.conditions, std::move(found),
                        "the side effect is confounded with the scores: no pair, and no round of "
                        "pairs, was shown in both orders");
    if (found.scale == Scale::Separated)
        return infinite(counts.conditions, found, describe(found));
    if (side_separated(counts.conditions, pairs))
        return infinite(counts.conditions, std::move(found), "the side explains every vote");
    return fit_choices(counts.conditions, pairs, {.side = true}, std::move(found));
}

ChoiceFit fit_davidson(const OrderedCounts& counts, Sides sides) {
    const std::size_t t = counts.conditions;
    const auto pairs = comparisons_of(counts);
    const auto wins = pooled(counts);
    if (counts.tied.empty() || total(counts.tied) == 0) {
        auto fit =
            sides == Sides::Fitted ? fit_bradley_terry_sides(counts) : fit_bradley_terry({t, wins});
        fit.reason += fit.reason.empty() ? "" : "; ";
        fit.reason += "no vote was a tie: nu is 0 and left out";
        return fit;
    }
    auto found = existence({t, wins});
    if (found.scale == Scale::Disconnected) {
        auto reason = "no common scale: " + describe(found);
        return no_scale(t, std::move(found), std::move(reason));
    }
    if (sides == Sides::Fitted && side_confounded(t, pairs))
        return no_scale(t, std::move(found),
                        "the side effect is confounded with the scores: no pair, and no round of "
                        "pairs, was shown in both orders");
    if (total(counts.first_chosen) + total(counts.second_chosen) == 0)
        return infinite(t, std::move(found), "every vote is a tie");
    if (found.scale == Scale::Separated)
        return infinite(t, found, describe(found));
    if (sides == Sides::Fitted && side_separated(t, pairs))
        return infinite(t, std::move(found), "the side explains every vote");
    if (ties_separated(t, pairs))
        return infinite(t, std::move(found), "ties only between neighbours on the scale");
    return fit_choices(t, pairs, {.side = sides == Sides::Fitted, .ties = true}, std::move(found));
}

std::vector<double> worths(const ChoiceFit& fit) {
    const double largest = *std::max_element(fit.theta.begin(), fit.theta.end());
    std::vector<double> result;
    double sum = 0;
    for (const double theta : fit.theta)
        sum += result.emplace_back(std::exp(theta - largest));
    for (double& worth : result)
        worth /= sum;
    return result;
}

} // namespace analysis::scaling
