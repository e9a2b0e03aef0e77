#include "analysis/vote_table.h"

namespace {

using analysis::vote_table;
using analysis::VoteRow;
using protocols::Choice;
using testing::HasSubstr;

const std::vector<VoteRow> rows{{"O1", "1", 1, {"bunny", "back"}, "A", "B", Choice::Left, 900},
                                {"O2", "1", 1, {"bunny", "back"}, "B", "C", Choice::Tie, -1}};

TEST(VoteTable, HoldsTheRowsInOrderOfFirstAppearance) {
    const auto table = vote_table({"scene", "variant"}, rows).value();
    EXPECT_EQ(table.conditions.names(), (std::vector<std::string>{"A", "B", "C"}));
    EXPECT_EQ(table.right, (std::vector<std::uint16_t>{1, 2}));
    EXPECT_EQ(table.observers.find("O2"), 1);
    EXPECT_EQ(table.observers.find("O3"), -1);
}

TEST(VoteTable, RefusesAConditionAgainstItselfAndARepeatedQuestion) {
    auto wrong = rows;
    wrong[1].right = "B";
    EXPECT_THAT(vote_table({"scene", "variant"}, wrong).error(),
                HasSubstr("vote 2: left and right are both 'B'"));
    wrong = rows;
    wrong.push_back(rows[0]);
    std::swap(wrong[2].left, wrong[2].right);
    EXPECT_THAT(vote_table({"scene", "variant"}, wrong).error(),
                HasSubstr("vote 3: O1 already answered this question in vote 1"));
}

TEST(VoteTable, FindsARepeatAmongMoreCellsThanABitmapHolds) {
    std::vector<VoteRow> many;
    for (int i = 0; i < 3000; ++i)
        many.push_back({"O" + std::to_string(i),
                        "S" + std::to_string(i),
                        1,
                        {"m" + std::to_string(i)},
                        "A",
                        "B",
                        Choice::Left,
                        -1});
    EXPECT_TRUE(vote_table({"model"}, many).has_value());
    many.push_back(many[17]);
    EXPECT_THAT(vote_table({"model"}, many).error(), HasSubstr("vote 3001: O17 already"));
}

TEST(VoteTable, TakesTheOrderOfConditionsFromTheStudy) {
    const auto table = vote_table({"scene", "variant"}, rows).value();
    const std::vector<std::string> order{"C", "A", "B"};
    const auto ordered = with_condition_order(table, order).value();
    EXPECT_EQ(ordered.conditions.names(), order);
    EXPECT_EQ(ordered.left, (std::vector<std::uint16_t>{1, 2}));
    EXPECT_EQ(ordered.right, (std::vector<std::uint16_t>{2, 0}));
}

TEST(VoteTable, AnOrderMustNameEveryConditionOnce) {
    const auto table = vote_table({"scene", "variant"}, rows).value();
    const auto error = [&](std::vector<std::string> order) {
        return with_condition_order(table, order).error();
    };
    EXPECT_THAT(error({"A", "B"}), HasSubstr("'C' has votes but is not in the order"));
    EXPECT_THAT(error({"A", "B", "C", "D"}), HasSubstr("'D' is in the order but has no votes"));
    EXPECT_THAT(error({"A", "A", "C"}), HasSubstr("'A' stands twice"));
}

} // namespace
