#include "analysis/vote_matrix.h"
#include "tests/analysis/golden.h"

namespace {

using analysis::VoteMatrix;
using protocols::Choice;

TEST(VoteMatrix, KeepsSidesApartAndAddsThemUp) {
    VoteMatrix matrix(3);
    matrix.add(0, 1, Choice::Left, 5);
    matrix.add(1, 0, Choice::Right, 2); // 1 left, 0 right, right chosen: 0 won
    matrix.add(1, 0, Choice::Left, 1);
    matrix.add(0, 2, Choice::Tie, 4);
    EXPECT_EQ(matrix.wins(0, 1), 7);
    EXPECT_EQ(matrix.wins(1, 0), 1);
    EXPECT_EQ(matrix.ties(2, 0), 4);
    EXPECT_EQ(matrix.comparisons(0, 1), 8);
    EXPECT_EQ(matrix.half_votes(0), 2 * 7 + 4);
    EXPECT_EQ(matrix.comparisons(0), 12);
    EXPECT_EQ(matrix.total_comparisons(), 12);
    EXPECT_EQ(matrix.total_ties(), 4);
    EXPECT_EQ(matrix.complete(), 0);
}

TEST(VoteMatrix, CountsAreExactBeyondWhatDoublesHold) {
    VoteMatrix matrix(2);
    matrix.add(0, 1, Choice::Left, (std::int64_t{1} << 53) + 1);
    EXPECT_EQ(matrix.wins(0, 1), (std::int64_t{1} << 53) + 1);
}

TEST(VoteMatrix, EveryScopeOfTheGoldenExperimentSumsToTheWhole) {
    const auto table = golden_votes();
    const auto whole = analysis::count_votes(table);
    EXPECT_EQ(whole.complete(), 270);
    const auto scopes = analysis::usual_scopes(table);
    ASSERT_EQ(scopes.size(), 9u);
    for (const auto& scope : scopes) {
        VoteMatrix sum(4);
        for (const auto& cell : analysis::count_votes(table, scope)) {
            EXPECT_GT(cell.matrix.complete(), 0) << cell.scope;
            sum.add(cell.matrix);
        }
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                if (i != j) {
                    EXPECT_EQ(sum.wins(i, j), whole.wins(i, j));
                    EXPECT_EQ(sum.left_chosen(i, j), whole.left_chosen(i, j));
                }
    }
}

TEST(VoteMatrix, LevelsSortAsPeopleCount) {
    std::vector<analysis::VoteRow> rows;
    for (const auto* session : {"10", "9", "1"})
        rows.push_back({"O1", session, 1, {}, "A", "B", Choice::Left, -1});
    const auto cells =
        analysis::count_votes(analysis::vote_table({}, rows).value(), {false, true, {}});
    ASSERT_EQ(cells.size(), 3u);
    EXPECT_EQ(cells[0].session, "1");
    EXPECT_EQ(cells[1].session, "9");
    EXPECT_EQ(cells[2].session, "10");
}

} // namespace
