#include "analysis/scaling/leave_one_out.h"
#include "tests/analysis/scaling/expect_fit.h"
#include "tests/analysis/scaling/golden_votes.h"

namespace {

using namespace analysis::scaling;

TEST(LeaveOneOut, MatchesTheSharedExperiment) {
    const auto expected = golden::read_json("experiment/expected.json")
                              .at("choice_models")
                              .at("leave_one_observer_out");
    const auto observers = golden::win_matrices("observer");
    const auto left = leave_one_out(golden::views(observers, 4), Link::Logit);
    ASSERT_EQ(left.size(), 10u);
    ASSERT_EQ(expected.size(), 10u);
    std::size_t at = 0;
    for (const auto& [name, wins] : observers) {
        const auto& row = expected[at];
        ASSERT_EQ(row.at("observer"), name);
        const auto near = [&](double value, const char* key) {
            EXPECT_NEAR(value / row.at(key).get<double>(), 1, 1e-11) << name << ' ' << key;
        };
        near(left[at].log_likelihood, "loo_loglik");
        near(left[at].log_likelihood_per_vote, "loo_loglik_per_vote");
        near(left[at].expected, "expected_loglik");
        near(left[at].z, "z");
        golden::expect_all_near(left[at].own_theta,
                                row.at("theta_ridge_0_1").get<std::vector<double>>(), 1e-12, name);
        ++at;
    }
}

TEST(LeaveOneOut, OfTwoThatNeverMetIsNotANumber) {
    const std::vector<std::int64_t> one{0, 3, 0, 2, 0, 0, 0, 0, 0},
        other{0, 0, 0, 0, 0, 4, 0, 1, 0};
    const std::vector<WinCounts> observers{{3, one}, {3, other}};
    const auto left = leave_one_out(observers, Link::Logit);
    EXPECT_EQ(left[0].others.estimate, Estimate::None);
    EXPECT_TRUE(std::isnan(left[0].z));
}

} // namespace
