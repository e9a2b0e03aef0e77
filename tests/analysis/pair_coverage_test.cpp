#include "analysis/pair_coverage.h"

namespace {

using namespace analysis;
using protocols::Choice;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

// Two triangles, 0 1 2 and 3 4 5, held together by one pair.
VoteMatrix two_triangles() {
    VoteMatrix matrix(6);
    for (const auto& [i, j] :
         {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}, {3, 4}, {3, 5}, {4, 5}})
        matrix.add(i, j, Choice::Left, 7);
    matrix.add(4, 2, Choice::Right, 3);
    return matrix;
}

TEST(PairCoverage, FindsThePairThatHoldsTheScaleTogether) {
    const auto coverage = pair_coverage(two_triangles());
    EXPECT_EQ(coverage.pairs, 15);
    EXPECT_EQ(coverage.compared, 7);
    EXPECT_EQ(coverage.fewest, 3);
    EXPECT_EQ(coverage.most, 7);
    EXPECT_THAT(coverage.rarest, Pair(2, 4));
    EXPECT_THAT(coverage.bridges, ElementsAre(Pair(2, 4)));
    const auto notes = coverage_notes(coverage, {"A", "B", "C", "D", "E", "F"});
    EXPECT_THAT(notes, Contains("7 of 15 pairs of conditions were compared at least once."));
    EXPECT_THAT(notes, Contains("Few comparisons: C with E only 3 times."));
    EXPECT_THAT(notes, Contains(HasSubstr("fall apart in two groups: C with E.")));
}

TEST(PairCoverage, OfAChainIsAllBridges) {
    VoteMatrix matrix(4);
    for (std::size_t i = 0; i < 3; ++i)
        matrix.add(i, i + 1, Choice::Left, 9);
    EXPECT_EQ(pair_coverage(matrix).bridges.size(), 3u);
}

TEST(PairCoverage, OfACompleteDesignSaysNothing) {
    VoteMatrix matrix(4);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
            matrix.add(i, j, Choice::Left, 5);
    const auto coverage = pair_coverage(matrix);
    EXPECT_TRUE(coverage.bridges.empty());
    EXPECT_TRUE(coverage_notes(coverage, {"A", "B", "C", "D"}).empty());
}

} // namespace
