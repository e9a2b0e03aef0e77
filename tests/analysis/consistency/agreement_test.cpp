#include "analysis/consistency/agreement.h"
#include "analysis/consistency/agreement_exact.h"
#include "analysis/consistency/repeatability.h"
#include "tests/analysis/numerics/golden_json.h"

#include <cmath>

namespace {

using namespace analysis::consistency;
using analysis::VoteMatrix;
using protocols::Choice;

TEST(Agreement, OfABillionJudgesDoesNotOverflow) {
    VoteMatrix matrix(20);
    for (std::size_t i = 0; i < 20; ++i)
        for (std::size_t j = i + 1; j < 20; ++j) {
            matrix.add(i, j, Choice::Left, 500'000'001);
            matrix.add(i, j, Choice::Right, 499'999'999);
        }
    EXPECT_DOUBLE_EQ(agreement(matrix).u, -9.99999997e-10);
}

TEST(Agreement, OfTwoJudgesHasNoChiSquared) {
    VoteMatrix matrix(3);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i + 1; j < 3; ++j)
            matrix.add(i, j, Choice::Left, 2);
    const auto result = agreement(matrix);
    EXPECT_EQ(result.u, 1);
    EXPECT_TRUE(std::isnan(result.p));
    EXPECT_THAT(result.reason, testing::HasSubstr("two judges"));
}

TEST(Agreement, ExactTailsAgreeWithTheTextbookSets) {
    const auto sets = golden::read_json("textbook_paired.json");
    int compared = 0;
    for (const auto& [name, set] : sets.items()) {
        if (!set.is_object() || !set.contains("agreement") ||
            !set["agreement"].contains("p_exact_sigma_at_least"))
            continue;
        const auto& row = set["agreement"];
        const auto p =
            agreement_p_exact(row["Sigma"].get<std::int64_t>(), row["m"].get<std::int64_t>(),
                              row["k"].get<std::int64_t>());
        ASSERT_TRUE(p) << name;
        // The golden ones were convolved in doubles: good to about 1e-14 of the law's largest term.
        EXPECT_NEAR(*p / row["p_exact_sigma_at_least"].get<double>(), 1, 1e-11) << name;
        ++compared;
    }
    EXPECT_GE(compared, 3);
}

// Two judges of three pairs: they agree on each with probability 1/2.
TEST(Agreement, ExactLawOfTwoJudgesIsBinomial) {
    EXPECT_EQ(agreement_p_exact(0, 2, 3), 1.0);
    EXPECT_EQ(agreement_p_exact(1, 2, 3), 7.0 / 8);
    EXPECT_EQ(agreement_p_exact(2, 2, 3), 4.0 / 8);
    EXPECT_EQ(agreement_p_exact(3, 2, 3), 1.0 / 8);
    EXPECT_EQ(agreement_p_exact(4, 2, 3), 0.0);
    EXPECT_FALSE(agreement_p_exact(4, 1'000'000'000, 20));
}

TEST(Agreement, IsForForcedChoicesOnEqualNumbers) {
    VoteMatrix matrix(2);
    EXPECT_EQ(agreement(matrix).reason, "the pairs were not judged equally often");
    matrix.add(0, 1, Choice::Tie, 3);
    EXPECT_EQ(agreement(matrix).reason, "u is for forced choices, and there are ties");
}

// 3 left of 4: P(X >= 3) = 5/16.  2 of 4 is the middle: the two tails overlap and p is capped.
TEST(SideBias, IsTheExactBinomial) {
    EXPECT_NEAR(side_bias(3, 4).p, 0.625, 1e-15);
    EXPECT_NEAR(side_bias(1, 4).p, 0.625, 1e-15);
    EXPECT_EQ(side_bias(2, 4).p, 1);
    EXPECT_NEAR(side_bias(10, 10).p, 2.0 / 1024, 1e-17);
    EXPECT_TRUE(std::isnan(side_bias(0, 0).p));
}

} // namespace
