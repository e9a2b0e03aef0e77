#include "analysis/consistency/screening.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/numerics/golden_json.h"

#include <cmath>

namespace {

using namespace analysis;
using consistency::screen_observers;
using protocols::Choice;
using testing::HasSubstr;

TEST(Screening, FindsNobodyAtFaultInTheSharedExperiment) {
    const auto observers = screen_observers(golden_votes());
    const auto expected = golden::read_json("experiment/expected.json")
                              .at("choice_models")
                              .at("leave_one_observer_out");
    ASSERT_EQ(observers.size(), 10u);
    for (std::size_t o = 0; o < 10; ++o) {
        EXPECT_EQ(observers[o].presentations, 36); // 9 scenes x 4 conditions
        EXPECT_EQ(observers[o].answers, 162);
        EXPECT_EQ(observers[o].rounds, 27);
        EXPECT_GT(observers[o].pearson, 0.5);
        EXPECT_NEAR(observers[o].left_out_z, expected[o]["z"].get<double>(), 1e-10);
        EXPECT_GT(observers[o].largest_shift, 0);
        EXPECT_LT(observers[o].largest_shift, 0.2);
    }
}

// Nine who agree, and one who chooses the left side always.
VoteTable panel_with_a_sleeper(bool sleeper_answers_fast) {
    std::vector<VoteRow> rows;
    const std::vector<std::string> names{"A", "B", "C", "D"};
    for (int o = 0; o < 10; ++o) {
        std::int32_t trial = 0;
        for (int scene = 0; scene < 6; ++scene)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = i + 1; j < 4; ++j) {
                    const bool swapped = (static_cast<std::size_t>(scene) + i + j) % 2 == 0;
                    const bool slip = (static_cast<std::size_t>(o + scene) + 2 * i + j) % 7 == 0;
                    const bool better_left = !swapped;
                    const bool left = o == 9 || better_left != slip;
                    rows.push_back({"O" + std::to_string(o),
                                    "1",
                                    ++trial,
                                    {"s" + std::to_string(scene)},
                                    swapped ? names[j] : names[i],
                                    swapped ? names[i] : names[j],
                                    left ? Choice::Left : Choice::Right,
                                    o == 9 && sleeper_answers_fast ? 100 : 900});
                }
    }
    return vote_table({"scene"}, rows).value();
}

TEST(Screening, FlagsWhoAlwaysChoosesOneSide) {
    const auto observers = screen_observers(panel_with_a_sleeper(true));
    const auto& sleeper = observers[9];
    const auto words = testing::PrintToString(sleeper.flags);
    EXPECT_THAT(words, HasSubstr("left chosen 36 of 36 times"));
    EXPECT_THAT(words, HasSubstr("36 answers in a row on one side"));
    EXPECT_THAT(words, HasSubstr("36 of 36 answers faster than 300 ms"));
    EXPECT_THAT(words, HasSubstr("z of the votes under the others' scale"));
    EXPECT_LT(sleeper.pearson, consistency::least_correlation);
    EXPECT_EQ(sleeper.longest_run, 36);
    EXPECT_NEAR(sleeper.longest_run_p, std::ldexp(1.0, -35), 1e-20);
    EXPECT_EQ(sleeper.median_ms, 100);
    for (std::size_t o = 0; o < 9; ++o)
        EXPECT_GT(observers[o].pearson, sleeper.pearson);
}

TEST(Screening, OfOneObserverSaysOnlyWhatOneObserverAllows) {
    auto table = vote_table({"scene"},
                            std::vector<VoteRow>{{"O1", "1", 1, {"s"}, "A", "B", Choice::Left, -1}})
                     .value();
    const auto observers = screen_observers(table);
    EXPECT_TRUE(std::isnan(observers[0].pearson));
    EXPECT_TRUE(std::isnan(observers[0].left_out_z));
    EXPECT_TRUE(std::isnan(observers[0].median_ms));
    EXPECT_TRUE(observers[0].flags.empty());
}

} // namespace
