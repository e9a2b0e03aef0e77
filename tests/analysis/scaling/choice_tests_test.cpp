#include "analysis/scaling/bradley_terry.h"
#include "analysis/scaling/choice_tests.h"
#include "tests/analysis/scaling/expect_fit.h"
#include "tests/analysis/scaling/golden_votes.h"

namespace {

using namespace analysis::scaling;

nlohmann::json choice_models() {
    return golden::read_json("experiment/expected.json").at("choice_models");
}

std::vector<std::int64_t> all_wins() {
    return golden::win_matrices("all").at("");
}

void expect_near(double value, const nlohmann::json& expected, double tolerance = 1e-12) {
    EXPECT_NEAR(value / expected.get<double>(), 1, tolerance);
}

TEST(ChoiceTests, MatchTheSharedExperiment) {
    const auto expected = choice_models().at("bradley_terry");
    const auto wins = all_wins();
    const WinCounts counts{4, wins};
    const auto fit = fit_bradley_terry(counts);
    const auto equality = equality_test(counts, fit);
    expect_near(equality.chi_squared, expected.at("LRT_equal_chi2"));
    EXPECT_EQ(equality.df, 3);
    expect_near(equality.p.p, expected.at("LRT_equal_p"), 1e-11);
    const auto goodness = goodness_of_fit(counts, fit, Link::Logit);
    expect_near(goodness.g2.chi_squared, expected.at("fit_G2"), 1e-11); // small beside its terms
    EXPECT_EQ(goodness.g2.df, 3);
    expect_near(goodness.g2.p.p, expected.at("fit_G2_p"), 1e-11);
    expect_near(goodness.x2.chi_squared, expected.at("fit_X2"));
    expect_near(goodness.x2.p.p, expected.at("fit_X2_p"));
}

TEST(ChoiceTests, ComparePairsAsTheGoldenDoes) {
    const auto expected = choice_models().at("bradley_terry").at("wald_pairs");
    const auto wins = all_wins();
    const auto pairs = wald_pairs(fit_bradley_terry({4, wins}));
    ASSERT_EQ(pairs.size(), 6u);
    ASSERT_EQ(expected.size(), 6u);
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_EQ(golden::methods()[pairs[k].a], expected[k].at("a"));
        EXPECT_EQ(golden::methods()[pairs[k].b], expected[k].at("b"));
        expect_near(pairs[k].difference, expected[k].at("diff"));
        expect_near(pairs[k].standard_error, expected[k].at("se"));
        expect_near(pairs[k].z, expected[k].at("z"));
        expect_near(pairs[k].p.p, expected[k].at("p"), 1e-11);
    }
}

TEST(ChoiceTests, FindThatModelsDiffer) {
    const auto expected = choice_models().at("heterogeneity_models");
    const auto models = golden::win_matrices("model");
    ASSERT_EQ(models.size(), 3u);
    const auto test = heterogeneity_test(golden::views(models, 4), Link::Logit);
    expect_near(test.chi_squared, expected.at("chi2"), 1e-11);
    EXPECT_EQ(test.df, 6);
    expect_near(test.p.p, expected.at("p"), 1e-10);
}

TEST(ChoiceTests, WidenTheErrorsWhenObserversDiffer) {
    const auto expected = choice_models().at("bradley_terry_cluster_robust");
    const auto observers = golden::win_matrices("observer");
    ASSERT_EQ(observers.size(), 10u);
    const auto views = golden::views(observers, 4);
    const auto wins = all_wins();
    auto fit = fit_bradley_terry({4, wins});
    const auto robust = cluster_robust_covariance(fit, views, Link::Logit, SmallSample::AsIs);
    std::vector<double> covariance;
    for (const auto& row : expected.at("cov_centered"))
        for (const auto& value : row)
            covariance.push_back(value.get<double>());
    golden::expect_all_near(robust, covariance, 1e-12, "robust covariance");
    fit.covariance = cluster_robust_covariance(fit, views, Link::Logit, SmallSample::Corrected);
    for (std::size_t i = 0; i < 4; ++i)
        expect_near(standard_error(fit, i), expected.at("se_centered_corrected")[i]);
}

TEST(ChoiceTests, SayNothingWhereTheyHaveNoMaximum) {
    const std::vector<std::int64_t> wins{0, 5, 0, 0};
    const WinCounts counts{2, wins};
    const auto fit = fit_bradley_terry(counts);
    EXPECT_EQ(fit.estimate, Estimate::Firth);
    EXPECT_TRUE(std::isnan(equality_test(counts, fit).p.p));
    EXPECT_TRUE(std::isnan(goodness_of_fit(counts, fit, Link::Logit).g2.chi_squared));
}

TEST(ChoiceTests, HaveNoPWithoutDegreesOfFreedom) {
    const std::vector<std::int64_t> wins{0, 5, 3, 0};
    const WinCounts counts{2, wins};
    const auto goodness = goodness_of_fit(counts, fit_bradley_terry(counts), Link::Logit);
    EXPECT_EQ(goodness.g2.df, 0);
    EXPECT_NEAR(goodness.g2.chi_squared, 0, 1e-13);
    EXPECT_TRUE(std::isnan(goodness.g2.p.p));
}

} // namespace
