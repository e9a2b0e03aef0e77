// The profile is walked with the contrast held: Newton's steps in the plane where it is constant.
// Both likelihoods are concave, so the profile falls on either side of the maximum.
#include "analysis/scaling/likelihood_interval.h"

#include "analysis/numerics/distributions.h"
#include "analysis/scaling/cholesky.h"
#include "analysis/scaling/fit_choices.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace analysis::scaling {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

class Profile {
  public:
    Profile(const WinCounts& counts,
            const ChoiceFit& fit,
            Link link,
            std::span<const double> contrast)
        : model_(counts.conditions, comparisons_of(counts), {.link = link}), contrast_(contrast),
          theta_(fit.theta) {}

    // The largest log-likelihood among scores whose contrast is `value`.  Starts from where the
    // last call ended.
    double at(double value) {
        move_to(value);
        model_.evaluate(theta_, here_);
        for (int iteration = 0; iteration < 100; ++iteration) {
            const double gain = step();
            if (!(gain > 1e-14 * (1 + std::abs(here_.log_likelihood))))
                break;
        }
        return here_.log_likelihood;
    }

  private:
    double dot(std::span<const double> a, std::span<const double> b) const {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            sum += a[i] * b[i];
        return sum;
    }

    void move_to(double value) {
        const double off = (value - dot(contrast_, theta_)) / dot(contrast_, contrast_);
        for (std::size_t i = 0; i < theta_.size(); ++i)
            theta_[i] += off * contrast_[i];
    }

    // One Newton step along the plane, halved while the likelihood falls; what it gained.
    double step() {
        const auto t = theta_.size();
        auto matrix = here_.information;
        double trace = 0;
        for (std::size_t i = 0; i < t; ++i)
            trace += matrix[i * t + i];
        const auto size = static_cast<double>(t);
        for (auto& element : matrix) // a common shift changes nothing: fill that direction
            element += trace / (size * size);
        if (!cholesky_.factor(matrix, t))
            return 0;
        std::vector<double> free = here_.gradient, held(contrast_.begin(), contrast_.end());
        cholesky_.solve(free);
        cholesky_.solve(held);
        const double pull = dot(contrast_, free) / dot(contrast_, held);
        for (std::size_t i = 0; i < t; ++i)
            free[i] -= pull * held[i];
        const double before = here_.log_likelihood;
        std::vector<double> next(t);
        ModelPoint there;
        for (double fraction = 1; fraction > 1e-10; fraction /= 2) {
            for (std::size_t i = 0; i < t; ++i)
                next[i] = theta_[i] + fraction * free[i];
            model_.evaluate(next, there);
            if (there.log_likelihood > before) {
                theta_ = next;
                std::swap(here_, there);
                return here_.log_likelihood - before;
            }
        }
        return 0;
    }

    ChoiceModel model_;
    std::span<const double> contrast_;
    std::vector<double> theta_;
    ModelPoint here_;
    Cholesky cholesky_;
};

// Where the profile has fallen by `drop` on one side of the maximum.  The signed root of the fall
// is nearly a straight line, so a secant between brackets is quick (Illinois' variant).
double crossing(Profile profile, double best, double estimate, double error, double drop) {
    const double aim = std::sqrt(2 * drop);
    const auto fall = [&](double value) {
        return std::sqrt(std::max(0.0, 2 * (best - profile.at(value)))) - aim;
    };
    double inside = estimate, below = -aim;
    double outside = estimate + aim * error, above = fall(outside);
    for (int doubling = 0; above < 0 && doubling < 60; ++doubling) {
        inside = outside;
        below = above;
        outside = estimate + (outside - estimate) * 2;
        above = fall(outside);
    }
    if (!(above >= 0))
        return nothing;
    int side = 0;
    for (int i = 0; i < 100; ++i) {
        const double middle = inside - below * (outside - inside) / (above - below);
        const double here = fall(middle);
        if (std::abs(outside - inside) <= 1e-13 * (1 + std::abs(middle)) || std::abs(here) < 1e-12)
            return middle;
        if (here < 0) {
            inside = middle;
            below = here;
            above /= side == -1 ? 2 : 1;
            side = -1;
        } else {
            outside = middle;
            above = here;
            below /= side == 1 ? 2 : 1;
            side = 1;
        }
    }
    return (inside + outside) / 2;
}

} // namespace

LikelihoodInterval likelihood_interval(const WinCounts& counts,
                                       const ChoiceFit& fit,
                                       Link link,
                                       std::span<const double> contrast,
                                       double level) {
    EXPECTS(contrast.size() == counts.conditions && level > 0 && level < 1);
    double sum = 0, estimate = 0, variance = 0;
    for (std::size_t i = 0; i < contrast.size(); ++i) {
        sum += contrast[i];
        estimate += contrast[i] * fit.theta[i];
        for (std::size_t j = 0; j < contrast.size(); ++j)
            variance += contrast[i] * contrast[j] * fit.covariance[i * contrast.size() + j];
    }
    EXPECTS(std::abs(sum) <= 1e-12);
    if (fit.estimate != Estimate::MaximumLikelihood || !(variance > 0))
        return {nothing, nothing};
    const double drop = numerics::chi_squared_quantile_upper(1 - level, 1) / 2;
    const Profile profile(counts, fit, link, contrast);
    const double error = std::sqrt(variance);
    return {crossing(profile, fit.log_likelihood, estimate, -error, drop),
            crossing(profile, fit.log_likelihood, estimate, error, drop)};
}

std::vector<LikelihoodInterval>
likelihood_intervals(const WinCounts& counts, const ChoiceFit& fit, Link link, double level) {
    const auto t = counts.conditions;
    std::vector<LikelihoodInterval> intervals;
    for (std::size_t i = 0; i < t; ++i) {
        std::vector<double> contrast(t, -1 / static_cast<double>(t));
        contrast[i] += 1;
        intervals.push_back(t < 2 ? LikelihoodInterval{nothing, nothing}
                                  : likelihood_interval(counts, fit, link, contrast, level));
    }
    return intervals;
}

} // namespace analysis::scaling
