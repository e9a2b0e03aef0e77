#include "experiment/cost/choices.h"
#include "tests/experiment/cost/small_report.h"

namespace {

using namespace experiment::cost;
using testing::HasSubstr;

SceneCost scene() {
    return tests::small_report().scenes.front();
}

TEST(CostChoice, IsTheCheapestWithinTheToleranceAndSaysWhatItLeavesOut) {
    const auto choice = choose(scene(), 0, {.error = ErrorKind::Law, .tolerance = 0.05});
    ASSERT_TRUE(choice);
    EXPECT_EQ(choice->row, 2U);
    EXPECT_EQ(choice->predicted, 0.04);
    EXPECT_THAT(choice->why, HasSubstr("2 of 4 settings are within 5 %, and this is the fastest"));
    EXPECT_THAT(choice->why,
                HasSubstr("error 4 %, 6 ms a frame, 16 bytes at each of 642 vertices"));
    EXPECT_THAT(choice->left_out,
                HasSubstr("fine: error 1 % instead of 4 %, 1.17 of the frame time, 100 instead of "
                          "16 bytes a vertex"));
}

// Of two that are as fast, the one on a quarter of the vertices takes less, though more at each.
TEST(CostChoice, CountsBytesOfTheWholeMeshThatIsDrawn) {
    auto coarse = scene();
    coarse.rows.push_back(tests::row("fine", "triangles 1/4", 6, 20, 0.045));
    coarse.rows.back().vertices = 162;
    coarse.rows.back().triangles = 320;
    coarse.rows.back().mesh_bytes = 7728;
    const auto choice = choose(coarse, 0, {.tolerance = 0.05});
    EXPECT_EQ(choice->row, 4U);
    EXPECT_EQ(bytes_in_all(coarse.rows[4]), 7728U + 162 * 20);
    EXPECT_THAT(choice->left_out,
                HasSubstr("100 instead of 20 bytes a vertex at 642 instead of 162 vertices"));
}

TEST(CostChoice, DependsOnTheLight) {
    // under the second light errors are twice as large: only the finest is good enough
    EXPECT_EQ(choose(scene(), 1, {.tolerance = 0.05})->row, 1U);
    EXPECT_THAT(choose(scene(), 1, {.tolerance = 0.05})->left_out, HasSubstr("nothing"));
}

TEST(CostChoice, SaysWhenNothingIsGoodEnough) {
    const auto choice = choose(scene(), 0, {.tolerance = 0.001});
    EXPECT_EQ(choice->row, 1U);
    EXPECT_THAT(choice->why,
                HasSubstr("no setting is within 0.1 %; this has the least error: 1 %"));
}

TEST(CostChoice, KeepsABudget) {
    const Wish wish{.error = ErrorKind::Law, .tolerance = {}, .budget_ms = 6.5};
    EXPECT_EQ(choose(scene(), 0, wish)->row, 2U);
    EXPECT_THAT(choose(scene(), 0, wish)->why,
                HasSubstr("the least error of the settings that draw a frame in 6.5 ms: 4 %"));
    const Wish hurried{.error = ErrorKind::Law, .tolerance = {}, .budget_ms = 1};
    EXPECT_EQ(choose(scene(), 0, hurried)->row, 0U);
    EXPECT_THAT(choose(scene(), 0, hurried)->why, HasSubstr("no setting draws a frame in 1 ms"));
}

TEST(CostChoice, GoesByTheErrorThatWasAskedFor) {
    EXPECT_EQ(choose(scene(), 0, {.error = ErrorKind::Fitted, .tolerance = 0.5})->row, 3U);
    EXPECT_FALSE(choose(scene(), 1, {.error = ErrorKind::Fitted, .tolerance = 0.5}));
}

TEST(CostLadder, NamesTheCheapestBelowEachError) {
    const auto rungs = ladder(scene(), 0, ErrorKind::Law);
    std::vector<std::optional<std::size_t>> rows;
    for (const auto& rung : rungs)
        rows.push_back(rung.row);
    //                                          1 %  2 %  5 %  10 % 20 % 50 %
    EXPECT_THAT(rows, testing::ElementsAre(1U, 1U, 2U, 2U, 0U, 0U));
    EXPECT_FALSE(ladder(scene(), 0, ErrorKind::Fitted).front().row);
}

TEST(CostErrors, HaveNamesThatAreReadBack) {
    for (const auto kind : all_errors)
        EXPECT_EQ(error_kind(name_of(kind)), kind);
    EXPECT_FALSE(error_kind("speed"));
}

} // namespace
