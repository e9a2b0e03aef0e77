#include "analysis/anova/permutation.h"

#include <cmath>
#include <vector>

namespace {

using analysis::anova::permute_labels;

// Two observers who agree, three levels: of the 6 arrangements of the second, only the observed
// one gives totals 4, 2, 0.
TEST(Permutation, OfASmallLayoutIsCountedByHand) {
    const auto test = permute_labels(std::vector<std::int64_t>{2, 1, 0, 2, 1, 0}, 3, 1);
    EXPECT_TRUE(test.complete);
    EXPECT_EQ(test.arrangements, 6);
    EXPECT_EQ(test.as_large, 1);
}

TEST(Permutation, OfEqualScoresIsOne) {
    const auto test = permute_labels(std::vector<std::int64_t>{1, 1, 1, 1, 1, 1}, 3, 1);
    EXPECT_EQ(test.p, 1);
}

// 8 observers of 3 levels have 6^7 = 279936 arrangements; the draws estimate the same p.
TEST(Permutation, DrawsOfTwoSeedsAgree) {
    std::vector<std::int64_t> few{2, 1, 0, 2, 0, 1, 1, 2, 0, 0, 2, 1,
                                  2, 1, 0, 1, 0, 2, 2, 1, 0, 0, 1, 2};
    const auto exact = permute_labels(few, 3, 1);
    ASSERT_TRUE(exact.complete);
    EXPECT_EQ(exact.arrangements, 279936);
    // The same scores twice over is too many to enumerate; the p of independent halves is smaller,
    // so compare draws of the larger layout among themselves and against their standard error.
    auto many = few;
    many.insert(many.end(), few.begin(), few.end());
    const auto one = permute_labels(many, 3, 1, 20000), other = permute_labels(many, 3, 2, 20000);
    EXPECT_FALSE(one.complete);
    EXPECT_EQ(one.arrangements, 20001);
    EXPECT_EQ(permute_labels(many, 3, 1, 20000).as_large, one.as_large); // a seed is a stream
    const double se = std::sqrt(2 * one.p * (1 - one.p) / 20000);
    EXPECT_LE(std::abs(one.p - other.p), 4 * se); // fails 1 in 16,000 seeds; these are fixed
}

} // namespace
