#include "analysis/numerics/distributions.h"
#include "analysis/scaling/bradley_terry.h"
#include "analysis/scaling/likelihood_interval.h"
#include "analysis/scaling/thurstone.h"
#include "tests/analysis/scaling/golden_votes.h"

#include <cmath>

namespace {

using namespace analysis::scaling;

// Two conditions are a binomial: the bounds are where its own log-likelihood has fallen enough.
TEST(LikelihoodInterval, OfTwoConditionsIsTheBinomials) {
    const std::vector<std::int64_t> wins{0, 14, 3, 0};
    const WinCounts counts{2, wins};
    const double drop = analysis::numerics::chi_squared_quantile_upper(0.05, 1) / 2;
    for (const Link link : {Link::Logit, Link::Probit}) {
        const auto fit = link == Link::Logit ? fit_bradley_terry(counts) : fit_thurstone(counts);
        const auto [lower, upper] =
            likelihood_interval(counts, fit, link, std::vector<double>{1, -1}, 0.95);
        EXPECT_LT(lower, fit.theta[0] - fit.theta[1]);
        EXPECT_GT(upper, fit.theta[0] - fit.theta[1]);
        for (const double d : {lower, upper}) {
            const double l = 14 * std::log(choice_probability(link, d)) +
                             3 * std::log(choice_probability(link, -d));
            EXPECT_NEAR(fit.log_likelihood - l, drop, 1e-10);
        }
    }
}

// No scores with the contrast at its bound do better than the profile says, and some do as well:
// at the bound the constrained maximum has fallen by exactly the quantile.
TEST(LikelihoodInterval, OfTheSharedExperimentIsNearTheWaldOne) {
    const auto wins = golden::win_matrices("all").at("");
    const WinCounts counts{4, wins};
    const auto fit = fit_bradley_terry(counts);
    const auto intervals = likelihood_intervals(counts, fit, Link::Logit, 0.95);
    ASSERT_EQ(intervals.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        // With 1,620 votes the likelihood is nearly a parabola: a hundredth of the width.
        const double half = 1.959963984540054 * standard_error(fit, i);
        EXPECT_NEAR(intervals[i].lower, fit.theta[i] - half, 0.02 * half);
        EXPECT_NEAR(intervals[i].upper, fit.theta[i] + half, 0.02 * half);
    }
}

TEST(LikelihoodInterval, RelabellingMovesItsBoundsAlong) {
    const std::vector<std::int64_t> wins{0, 7, 9, 2, 0, 5, 1, 4, 0};
    std::vector<std::int64_t> reversed(9);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            reversed[(2 - i) * 3 + (2 - j)] = wins[i * 3 + j];
    const WinCounts a{3, wins}, b{3, reversed};
    const auto one = likelihood_intervals(a, fit_bradley_terry(a), Link::Logit, 0.9);
    const auto other = likelihood_intervals(b, fit_bradley_terry(b), Link::Logit, 0.9);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(one[i].lower, other[2 - i].lower, 1e-9);
        EXPECT_NEAR(one[i].upper, other[2 - i].upper, 1e-9);
    }
}

TEST(LikelihoodInterval, IsUndefinedWhereTheMaximumIsInfinite) {
    const std::vector<std::int64_t> wins{0, 5, 0, 0};
    const WinCounts counts{2, wins};
    const auto intervals =
        likelihood_intervals(counts, fit_bradley_terry(counts), Link::Logit, 0.95);
    EXPECT_TRUE(std::isnan(intervals[0].lower));
}

} // namespace
