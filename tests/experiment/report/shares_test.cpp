#include "experiment/report/shares.h"

#include <cmath>

namespace {

using namespace experiment::report;
using protocols::Choice;

TEST(VoteShares, CountTheRowOverTheColumnAndHalfTheTies) {
    analysis::VoteMatrix matrix(2);
    matrix.add(0, 1, Choice::Left, 3);  // 0 over 1
    matrix.add(1, 0, Choice::Right, 1); // 0 over 1, from the other side
    matrix.add(1, 0, Choice::Left, 2);  // 1 over 0
    matrix.add(0, 1, Choice::Tie, 1);
    EXPECT_EQ(votes_over(matrix, 0, 1), 4.5);
    EXPECT_EQ(votes_over(matrix, 1, 0), 2.5);
    EXPECT_DOUBLE_EQ(share_over(matrix, 0, 1), 4.5 / 7);
    EXPECT_TRUE(std::isnan(share_over(analysis::VoteMatrix(2), 0, 1)));
}

TEST(ShareColours, AreBlueAboveHalfAndOrangeBelow) {
    EXPECT_EQ(share_colour(0.5), "#f6f6f4");
    EXPECT_EQ(share_colour(1), "#6ca5d3");
    EXPECT_EQ(share_colour(0), "#e89f5a");
    EXPECT_EQ(share_colour(std::nan("")), "#ffffff");
}

} // namespace
