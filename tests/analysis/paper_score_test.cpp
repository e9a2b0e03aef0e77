#include "analysis/paper_score.h"
#include "tests/analysis/golden.h"

#include <cmath>

namespace {

using analysis::VoteRow;
using protocols::Choice;

TEST(PaperScore, EqualScoresShareTheMiddleRankAndKeepTheirOrder) {
    // A beats C, B beats C, A ties B: A and B have 1.5 of 2 each.
    const std::vector<VoteRow> rows{{"O1", "1", 1, {}, "C", "A", Choice::Right, -1},
                                    {"O1", "1", 2, {}, "B", "C", Choice::Left, -1},
                                    {"O1", "1", 3, {}, "A", "B", Choice::Tie, -1}};
    const auto scores = analysis::paper_scores(analysis::vote_table({}, rows).value());
    ASSERT_EQ(scores.size(), 3u);
    EXPECT_EQ(scores[1].condition, "A");
    EXPECT_EQ(scores[1].total_votes, 1.5);
    EXPECT_EQ(scores[1].rank, 1.5);
    EXPECT_EQ(scores[2].rank, 1.5);
    EXPECT_EQ(scores[0].rank, 3);
    EXPECT_EQ(analysis::ranking(scores), (std::vector<std::size_t>{1, 2, 0}));
    EXPECT_TRUE(std::isnan(scores[0].se_over_observers)); // one observer has no spread
    EXPECT_TRUE(std::isnan(scores[0].mean_votes_per_observer_and_factor)); // no scenes at all
}

TEST(PaperScore, WithMissingVotesEveryObserverWeighsTheSame) {
    // O1 answers 3 times for A against B, O2 once for B.
    std::vector<VoteRow> rows;
    for (const auto* scene : {"x", "y", "z"})
        rows.push_back({"O1", "1", 1, {scene}, "A", "B", Choice::Left, -1});
    rows.push_back({"O2", "1", 1, {"x"}, "A", "B", Choice::Right, -1});
    const auto scores = analysis::paper_scores(analysis::vote_table({"scene"}, rows).value());
    EXPECT_EQ(scores[0].share, 0.5);
    EXPECT_EQ(scores[0].share_pooled, 0.75);
}

TEST(PaperScore, ScoresSumToAConstant) {
    double sum = 0;
    for (const auto& score : analysis::paper_scores(golden_votes()))
        sum += score.total_votes;
    EXPECT_EQ(sum, 1620);
}

} // namespace
