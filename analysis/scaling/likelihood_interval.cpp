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
constexpr double close_enough = 1e-6; // of the root of the fall: Newton's next step squares it

class Profile {
  public:
    Profile(const WinCounts& counts,
            const ChoiceFit& fit,
            Link link,
            std::span<const double> contrast)
        : model_(counts.conditions, comparisons_of(counts), {.link = link}), contrast_(contrast),
          theta_(fit.theta) {}

    // The largest log-likelihood among scores whose contrast is `value`.  Starts from where the
    // last call ended, along the line on which the profile ran there.
    double at(double value) {
        if (tangent_.empty()) {
            model_.evaluate(theta_, here_);
            solve();
        }
        const double off = value - dot(contrast_, theta_);
        for (std::size_t i = 0; i < theta_.size(); ++i)
            theta_[i] += off * tangent_[i];
        model_.evaluate(theta_, here_);
        for (int iteration = 0; iteration < 100 && solve(); ++iteration) {
            const double gain = dot(here_.gradient, free_) / 2;
            if (!(gain > 1e-15 * (1 + std::abs(here_.log_likelihood))) || !step())
                break;
        }
        return here_.log_likelihood;
    }

    // By how much it changes with the value, where `at` was last called.
    double slope() const { return slope_; }

  private:
    static double dot(std::span<const double> a, std::span<const double> b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            sum += a[i] * b[i];
        return sum;
    }

    // Newton's step in the plane, the profile's direction and its slope; false where there is none.
    bool solve() {
        const auto t = theta_.size();
        auto matrix = here_.information;
        double trace = 0;
        for (std::size_t i = 0; i < t; ++i)
            trace += matrix[i * t + i];
        const auto size = static_cast<double>(t);
        for (auto& element : matrix) // a common shift changes nothing: fill that direction
            element += trace / (size * size);
        if (!cholesky_.factor(matrix, t)) {
            if (tangent_.empty())
                tangent_.assign(t, nothing);
            return false;
        }
        free_ = here_.gradient;
        tangent_.assign(contrast_.begin(), contrast_.end());
        cholesky_.solve(free_);
        cholesky_.solve(tangent_);
        const double length = dot(contrast_, tangent_);
        slope_ = dot(contrast_, free_) / length;
        for (std::size_t i = 0; i < t; ++i) {
            free_[i] -= slope_ * tangent_[i];
            tangent_[i] /= length;
        }
        return true;
    }

    // That step, halved while the likelihood falls; false when nothing is gained.
    bool step() {
        std::vector<double> next(theta_.size());
        ModelPoint there;
        for (double fraction = 1; fraction > 1e-10; fraction /= 2) {
            for (std::size_t i = 0; i < theta_.size(); ++i)
                next[i] = theta_[i] + fraction * free_[i];
            model_.evaluate(next, there);
            if (there.log_likelihood > here_.log_likelihood) {
                theta_ = next;
                std::swap(here_, there);
                return true;
            }
        }
        return false;
    }

    ChoiceModel model_;
    std::span<const double> contrast_;
    std::vector<double> theta_;
    ModelPoint here_;
    Cholesky cholesky_;
    std::vector<double> free_;    ///< the step that leaves the contrast as it is
    std::vector<double> tangent_; ///< of the profile, for a change of the contrast by one
    double slope_ = 0;
};

// Where the profile has fallen by `drop` on one side of the maximum, the side of `error`.  The
// signed root of the fall is nearly a straight line, so Newton's steps are few; a bracket keeps
// them.
double crossing(Profile profile, double best, double estimate, double error, double drop) {
    const double aim = std::sqrt(2 * drop);
    double value = estimate + aim * error, inside = estimate, outside = nothing;
    for (int i = 0; i < 200; ++i) {
        const double root = std::sqrt(std::max(0.0, 2 * (best - profile.at(value))));
        const double off = root - aim;
        if (std::isnan(off) || std::isinf(value))
            return nothing;
        (off < 0 ? inside : outside) = value;
        double next = value + off * root / profile.slope(); // the root's slope is -slope / root
        if (std::abs(off) <= close_enough)
            return next;
        const bool bracketed = !std::isnan(outside);
        const bool ahead = (next - inside) * error > 0;
        if (!ahead || (bracketed && (outside - next) * error <= 0))
            next = bracketed ? (inside + outside) / 2 : estimate + 2 * (value - estimate);
        value = next;
    }
    return nothing;
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
