#include "protocols/main_order.h"
#include "tests/protocols/designs.h"

#include <algorithm>
#include <map>

namespace {

using namespace protocols;
using tests::design;

Rng rng(std::uint8_t low) {
    Seed seed{};
    seed.back() = low;
    return Rng(seed);
}

int nearest_return(const std::vector<std::size_t>& order) {
    std::map<std::size_t, std::size_t> last;
    std::size_t nearest = order.size();
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (const auto before = last.find(order[i]); before != last.end())
            nearest = std::min(nearest, i - before->second);
        last[order[i]] = i;
    }
    return static_cast<int>(nearest);
}

TEST(MainOrder, AsksEveryQuestionAsOftenAsItShould) {
    const auto questions = all_questions(design(3, 2, 3));
    auto stream = rng(1);
    const auto drawn = draw_main_order(questions, 2, stream);
    std::vector<int> asked(questions.size());
    for (const auto i : drawn.questions)
        ++asked.at(i);
    EXPECT_THAT(asked, testing::Each(2));
}

// Two scenes with two questions each: 2 patterns of scenes times 2 x 2 deals are 8 orders.
TEST(MainOrder, IsUniformOverAllOrdersThatKeepScenesApart) {
    const auto questions = all_questions(design(2, 2, 2));
    std::map<std::vector<std::size_t>, int> cells;
    auto stream = rng(2);
    for (int i = 0; i < 16000; ++i)
        ++cells[draw_main_order(questions, 1, stream).questions];
    ASSERT_EQ(cells.size(), 8u);
    double chi_square = 0;
    for (const auto& [order, count] : cells)
        chi_square += (count - 2000.0) * (count - 2000.0) / 2000.0;
    EXPECT_LE(chi_square, 24.32); // 7 degrees of freedom, 0.001
}

TEST(MainOrder, KeepsARepeatedQuestionAwayForThreeTrials) {
    auto stream = rng(3);
    for (const auto& [variants, conditions, repetitions] :
         std::vector<std::array<int, 3>>{{3, 4, 2}, {3, 4, 3}, {3, 2, 4}, {1, 3, 3}, {3, 4, 5}}) {
        const auto questions = all_questions(design(3, variants, conditions));
        for (int i = 0; i < 20; ++i) {
            const auto drawn = draw_main_order(questions, repetitions, stream);
            EXPECT_EQ(drawn.close_repeats, 0) << variants << conditions << repetitions;
            EXPECT_GT(nearest_return(drawn.questions), repeat_gap);
        }
    }
}

TEST(MainOrder, CountsTheRepeatsItCannotKeepAway) {
    const auto questions = all_questions(design(1, 0, 2)); // one question, again and again
    auto stream = rng(4);
    const auto drawn = draw_main_order(questions, 5, stream);
    EXPECT_EQ(drawn.close_repeats, 4);
    EXPECT_EQ(drawn.equal_neighbours, 4);
}

TEST(MainOrder, OfOneSceneHasOnlyEqualNeighbours) {
    const auto questions = all_questions(design(1, 3, 3));
    auto stream = rng(5);
    EXPECT_EQ(draw_main_order(questions, 1, stream).equal_neighbours, 8);
}

} // namespace
