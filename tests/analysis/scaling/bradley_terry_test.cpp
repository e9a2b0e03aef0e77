#include "analysis/scaling/bradley_terry.h"
#include "analysis/scaling/choice_tests.h"
#include "tests/analysis/scaling/expect_fit.h"
#include "tests/analysis/scaling/golden_votes.h"

#include <cmath>

namespace {

using namespace analysis::scaling;
using testing::HasSubstr;

// Golden fits were made at 50 digits; a double fit reaches about 1e-14 of the largest score.
constexpr double fit_tolerance = 1e-12;

nlohmann::json choice_models() {
    return golden::read_json("experiment/expected.json").at("choice_models");
}

std::vector<std::int64_t> all_wins() {
    return golden::win_matrices("all").at("");
}

TEST(BradleyTerry, FitsTheSharedExperiment) {
    const auto expected = choice_models();
    const auto wins = all_wins();
    const WinCounts counts{4, wins};
    golden::expect_fit(fit_bradley_terry(counts), expected.at("bradley_terry"), fit_tolerance,
                       "ml");
    golden::expect_fit(fit_bradley_terry_firth(counts), expected.at("bradley_terry_firth"),
                       fit_tolerance, "Firth");
    golden::expect_fit(fit_bradley_terry_ridge(counts, 1), expected.at("bradley_terry_ridge_1"),
                       fit_tolerance, "ridge");
    for (const auto& [model, own] : golden::win_matrices("model"))
        golden::expect_fit(fit_bradley_terry({4, own}), expected.at("bradley_terry_model_" + model),
                           fit_tolerance, model);
}

TEST(BradleyTerry, FitsTheSideOfTheSharedExperiment) {
    const auto expected = choice_models().at("bradley_terry_side");
    // Rows are [left, right, left chosen, right chosen].
    const golden::Votes votes(4, expected.at("left_right_counts"));
    const auto fit = fit_bradley_terry_sides(votes.ordered());
    golden::expect_fit(fit, expected, fit_tolerance, "side");
    ASSERT_TRUE(fit.side);
    EXPECT_NEAR(fit.side->value, expected.at("side").get<double>(), 1e-13);
    EXPECT_NEAR(fit.side->standard_error, expected.at("side_se").get<double>(), 1e-13);
    const auto wins = votes.wins();
    const auto test = likelihood_ratio_test(fit_bradley_terry({4, wins}), fit, 1);
    EXPECT_NEAR(test.chi_squared, expected.at("LRT_side_chi2").get<double>(), 1e-11);
    EXPECT_NEAR(test.p.p, expected.at("LRT_side_p").get<double>(), 1e-12);
}

TEST(BradleyTerry, FitsThePublishedOrderEffect) {
    const auto expected = golden::read_json("textbook_paired.json").at("heaviness_order").at("fit");
    const golden::Votes votes(5, expected.at("comparisons"));
    const auto fit = fit_bradley_terry_sides(votes.ordered());
    golden::expect_fit(fit, expected, fit_tolerance, "heaviness");
    ASSERT_TRUE(fit.side);
    EXPECT_NEAR(fit.side->value, expected.at("side").get<double>(), 1e-13);
    EXPECT_NEAR(fit.side->standard_error, expected.at("side_se").get<double>(), 1e-13);
    const auto wins = votes.wins();
    const auto test = likelihood_ratio_test(fit_bradley_terry({5, wins}), fit, 1);
    EXPECT_NEAR(test.chi_squared, expected.at("LRT_order_chi2").get<double>(), 1e-11);
    EXPECT_NEAR(test.p.p / expected.at("LRT_order_p").get<double>(), 1, 1e-11);
}

TEST(BradleyTerry, FitsDavidsonsTies) {
    const auto expected = golden::read_json("textbook_paired.json");
    for (const auto& [name, sides] :
         {std::pair{"davidson_ties", Sides::Ignored}, {"davidson_ties_and_order", Sides::Fitted}}) {
        const auto& golden_fit = expected.at(name).at("fit");
        const golden::Votes votes(4, expected.at(name).at("comparisons"));
        const auto fit = fit_davidson(votes.ordered(), sides);
        golden::expect_fit(fit, golden_fit, fit_tolerance, name);
        ASSERT_TRUE(fit.log_nu);
        EXPECT_NEAR(fit.log_nu->value, golden_fit.at("log_nu").get<double>(), 1e-13);
        EXPECT_NEAR(fit.log_nu->standard_error, golden_fit.at("log_nu_se").get<double>(), 1e-13);
        EXPECT_EQ(fit.side.has_value(), sides == Sides::Fitted);
        if (fit.side) {
            EXPECT_NEAR(fit.side->value, golden_fit.at("side").get<double>(), 1e-13);
            EXPECT_NEAR(fit.side->standard_error, golden_fit.at("side_se").get<double>(), 1e-13);
        }
    }
}

TEST(BradleyTerry, AnswersTheHardCases) {
    const auto cases = golden::read_json("hard_cases.json").at("choice_models");
    int fits = 0;
    for (const auto& [name, expected] : cases.items()) {
        const golden::Votes votes(expected.at("k").get<std::size_t>(), expected.at("comparisons"));
        const auto wins = votes.wins();
        const WinCounts counts{votes.conditions, wins};
        const auto fit = fit_bradley_terry(counts);
        EXPECT_EQ(fit.existence.scale == Scale::Finite, expected.at("mle_finite").get<bool>())
            << name;
        // 1e-10 is promised of every fit; a ratio of 1e15 leaves the smaller probability 15 digits.
        constexpr double tolerance = 1e-10;
        if (expected.contains("bradley_terry")) {
            EXPECT_EQ(fit.estimate, Estimate::MaximumLikelihood);
            golden::expect_fit(fit, expected.at("bradley_terry"), tolerance, name);
            ++fits;
        }
        if (expected.contains("bradley_terry_firth")) {
            golden::expect_fit(fit_bradley_terry_firth(counts), expected.at("bradley_terry_firth"),
                               tolerance, name + " Firth");
            ++fits;
        }
        golden::expect_fit(fit_bradley_terry_ridge(counts, 1), expected.at("bradley_terry_ridge_1"),
                           tolerance, name + " ridge");
    }
    EXPECT_GE(fits, 14);
}

TEST(BradleyTerry, KeepsTheDigitsOfAGapOfABillionthUnderABillionVotes) {
    const std::vector<std::int64_t> wins{0,          1000000000, 1000000000, 1000000000, 0,
                                         1000000001, 1000000000, 999999999,  0};
    const auto fit = fit_bradley_terry({3, wins});
    // Equal but for one vote in the last pair: theta_1 = -theta_2 = 2/3 1e-9 to first order.
    EXPECT_NEAR(fit.theta[1] / (2e-9 / 3), 1, 1e-9);
    EXPECT_NEAR(fit.theta[0], 0, 1e-18);
}

TEST(BradleyTerry, NamesTheConditionThatNeverLoses) {
    const std::vector<std::int64_t> wins{0, 9, 9, 9, 0, 0, 6, 5, 0, 3, 0, 3, 0, 4, 6, 0};
    const auto fit = fit_bradley_terry({4, wins});
    EXPECT_EQ(fit.estimate, Estimate::Firth);
    EXPECT_EQ(fit.reason, "no finite maximum of the likelihood: {0} above {1, 2, 3}; Firth's "
                          "penalised estimate instead");
    EXPECT_GT(fit.theta[0], 1);
}

TEST(BradleyTerry, RefusesAScaleAcrossConditionsNeverCompared) {
    const std::vector<std::int64_t> wins{0, 8, 0, 0, 2, 0, 0, 0, 0, 0, 0, 3, 0, 0, 7, 0};
    const auto fit = fit_bradley_terry({4, wins});
    EXPECT_EQ(fit.estimate, Estimate::None);
    EXPECT_EQ(fit.reason, "no common scale: {0, 1} apart from {2, 3}");
    EXPECT_TRUE(std::isnan(fit.theta[0]) && std::isnan(fit.log_likelihood));
    EXPECT_EQ(fit_bradley_terry_ridge({4, wins}, 1).estimate, Estimate::Ridge);
}

TEST(BradleyTerry, OfOneConditionIsZero) {
    const std::vector<std::int64_t> wins{0};
    const auto fit = fit_bradley_terry({1, wins});
    EXPECT_EQ(fit.theta, std::vector<double>{0.0});
    EXPECT_EQ(worths(fit), std::vector<double>{1.0});
}

// A tree of pairs: every difference is the logit of its own pair.
TEST(BradleyTerry, OfAChainIsTheSumOfItsLogits) {
    const std::vector<std::int64_t> wins{0, 1000, 0, 1, 0, 30, 0, 10, 0};
    const auto fit = fit_bradley_terry({3, wins});
    EXPECT_NEAR(fit.theta[0] - fit.theta[1], std::log(1000), 1e-13);
    EXPECT_NEAR(fit.theta[1] - fit.theta[2], std::log(3), 1e-14);
    EXPECT_NEAR(difference_standard_error(fit, 1, 2), std::sqrt(1.0 / 30 + 1.0 / 10), 1e-14);
}

TEST(BradleyTerry, DoesNotCareHowConditionsAreNumbered) {
    const auto wins = all_wins();
    const std::size_t order[4] = {2, 0, 3, 1};
    std::vector<std::int64_t> renumbered(16);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            renumbered[i * 4 + j] = wins[order[i] * 4 + order[j]];
    const auto fit = fit_bradley_terry({4, wins}), other = fit_bradley_terry({4, renumbered});
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(other.theta[i], fit.theta[order[i]], 1e-14);
        EXPECT_NEAR(standard_error(other, i), standard_error(fit, order[i]), 1e-15);
    }
}

TEST(BradleyTerry, TurnsAroundWhenWinnersAndLosersAreSwapped) {
    const auto wins = all_wins();
    std::vector<std::int64_t> swapped(16);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            swapped[i * 4 + j] = wins[j * 4 + i];
    const auto fit = fit_bradley_terry({4, wins}), other = fit_bradley_terry({4, swapped});
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(other.theta[i], -fit.theta[i], 1e-14);
}

TEST(BradleyTerrySides, MirroringTheSidesChangesTheSignOfTheSideOnly) {
    const auto expected = golden::read_json("textbook_paired.json").at("davidson_ties_and_order");
    const golden::Votes votes(4, expected.at("comparisons"));
    golden::Votes mirrored(4);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            mirrored.first_chosen[j * 4 + i] = votes.second_chosen[i * 4 + j];
            mirrored.second_chosen[j * 4 + i] = votes.first_chosen[i * 4 + j];
            mirrored.tied[j * 4 + i] = votes.tied[i * 4 + j];
        }
    const auto fit = fit_davidson(votes.ordered(), Sides::Fitted);
    const auto other = fit_davidson(mirrored.ordered(), Sides::Fitted);
    ASSERT_TRUE(fit.side && other.side);
    EXPECT_NEAR(other.side->value, -fit.side->value, 1e-14);
    EXPECT_NEAR(other.log_nu->value, fit.log_nu->value, 1e-14);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(other.theta[i], fit.theta[i], 1e-14);
}

TEST(BradleyTerrySides, RefusesAnOrderThatAScaleImitates) {
    golden::Votes one_way(3); // every pair shown one way only
    for (const std::size_t at : {1u, 2u, 5u}) {
        one_way.first_chosen[at] = 5;
        one_way.second_chosen[at] = 4;
    }
    // 0-1, 1-2 and 0-2 as first-second: 0-2 would need the difference 2, so this is identified ...
    EXPECT_EQ(fit_bradley_terry_sides(one_way.ordered()).estimate, Estimate::MaximumLikelihood);
    one_way.first_chosen[2] = one_way.second_chosen[2] = 0; // ... and without it, it is not.
    const auto fit = fit_bradley_terry_sides(one_way.ordered());
    EXPECT_EQ(fit.estimate, Estimate::None);
    EXPECT_THAT(fit.reason, HasSubstr("confounded"));
}

TEST(BradleyTerrySides, RefusesASideThatExplainsEveryVote) {
    golden::Votes votes(2);
    votes.first_chosen[1] = votes.first_chosen[2] = 7; // left, always
    const auto fit = fit_bradley_terry_sides(votes.ordered());
    EXPECT_EQ(fit.estimate, Estimate::None);
    EXPECT_THAT(fit.reason, HasSubstr("the side explains every vote"));
}

TEST(Davidson, WithoutATieIsBradleyTerry) {
    golden::Votes votes(2);
    votes.first_chosen[1] = 7;
    votes.second_chosen[1] = 3;
    const auto fit = fit_davidson(votes.ordered(), Sides::Ignored);
    EXPECT_NEAR(fit.theta[0] - fit.theta[1], std::log(7.0 / 3), 1e-14);
    EXPECT_FALSE(fit.log_nu);
    EXPECT_EQ(fit.reason, "no vote was a tie: nu is 0 and left out");
}

TEST(Davidson, RefusesWhatHasNoMaximum) {
    golden::Votes only_ties(2);
    only_ties.tied[1] = 4;
    EXPECT_THAT(fit_davidson(only_ties.ordered(), Sides::Ignored).reason,
                HasSubstr("every vote is a tie"));
    golden::Votes neighbours(2); // never loses, sometimes ties: both grow without end together
    neighbours.first_chosen[1] = 6;
    neighbours.tied[1] = 3;
    EXPECT_THAT(fit_davidson(neighbours.ordered(), Sides::Ignored).reason,
                HasSubstr("ties only between neighbours"));
}

// Two conditions: nu, d and their shares have a closed form.
TEST(Davidson, OfTwoConditionsHasItsClosedForm) {
    golden::Votes votes(2);
    votes.first_chosen[1] = 12;
    votes.second_chosen[1] = 3;
    votes.tied[1] = 5;
    const auto fit = fit_davidson(votes.ordered(), Sides::Ignored);
    EXPECT_NEAR(fit.theta[0] - fit.theta[1], std::log(12.0 / 3), 1e-14);
    EXPECT_NEAR(fit.log_nu->value, std::log(5 / std::sqrt(12.0 * 3)), 1e-14);
}

// One vote: Jeffreys' prior adds half a vote to each side, so the odds are 1.5 to 0.5.
TEST(Firth, OfASingleVoteIsThreeToOne) {
    const std::vector<std::int64_t> wins{0, 1, 0, 0};
    const auto fit = fit_bradley_terry({2, wins});
    EXPECT_EQ(fit.estimate, Estimate::Firth);
    EXPECT_NEAR(fit.theta[0] - fit.theta[1], std::log(3.0), 1e-13);
}

} // namespace
