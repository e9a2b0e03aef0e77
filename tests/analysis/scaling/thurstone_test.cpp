#include "analysis/numerics/distributions.h"
#include "analysis/scaling/thurstone.h"
#include "tests/analysis/scaling/expect_fit.h"
#include "tests/analysis/scaling/golden_votes.h"

namespace {

using namespace analysis::scaling;

TEST(Thurstone, FitsTheSharedExperimentInItsThreeUnits) {
    const auto expected = golden::read_json("experiment/expected.json").at("choice_models");
    const auto wins = golden::win_matrices("all").at("");
    const WinCounts counts{4, wins};
    const auto fit = fit_thurstone(counts);
    golden::expect_fit(fit, expected.at("thurstone_V_unit_sigma_difference"), 1e-12, "unit");
    golden::expect_fit(fit_thurstone_jod(counts), expected.at("thurstone_V_JOD"), 1e-12, "JOD");
    golden::expect_fit(in_unit(fit, 1.4826), expected.at("thurstone_V_JOD_sigma_1.4826"), 1e-12,
                       "1.4826");
}

TEST(Thurstone, OneJodIsChosenThreeTimesInFour) {
    EXPECT_NEAR(jod_sigma, 1 / analysis::numerics::normal_quantile(0.75), 1e-15);
    const std::vector<std::int64_t> wins{0, 3, 1, 0};
    const auto fit = fit_thurstone_jod({2, wins});
    EXPECT_NEAR(fit.theta[0] - fit.theta[1], 1, 1e-14);
}

TEST(Thurstone, AnswersTheHardCases) {
    const auto cases = golden::read_json("hard_cases.json").at("choice_models");
    int fits = 0;
    for (const auto& [name, expected] : cases.items()) {
        const golden::Votes votes(expected.at("k").get<std::size_t>(), expected.at("comparisons"));
        const auto wins = votes.wins();
        const WinCounts counts{votes.conditions, wins};
        if (expected.contains("thurstone_V")) {
            golden::expect_fit(fit_thurstone(counts), expected.at("thurstone_V"), 1e-10, name);
            ++fits;
        }
        golden::expect_fit(fit_thurstone_ridge(counts, 1), expected.at("thurstone_V_ridge_1"),
                           1e-10, name + " ridge");
    }
    EXPECT_GE(fits, 6);
}

TEST(Thurstone, SaysWhenAScoreWouldBeInfinite) {
    const std::vector<std::int64_t> wins{0, 5, 0, 0};
    const auto fit = fit_thurstone({2, wins});
    EXPECT_EQ(fit.estimate, Estimate::Ridge);
    EXPECT_EQ(fit.reason, "no finite maximum of the likelihood: {0} above {1}; ridge instead");
}

TEST(Thurstone, OfTwoConditionsIsTheQuantileOfTheirShare) {
    const std::vector<std::int64_t> wins{0, 999999, 1, 0};
    const auto fit = fit_thurstone({2, wins});
    EXPECT_NEAR(fit.theta[0] - fit.theta[1], -analysis::numerics::normal_quantile(1e-6), 1e-13);
}

} // namespace
