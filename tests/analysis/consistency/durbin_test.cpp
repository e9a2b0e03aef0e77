#include "analysis/consistency/durbin.h"
#include "tests/analysis/numerics/golden_json.h"

#include <cmath>

namespace {

using namespace analysis::consistency;

std::vector<IncompleteBlock> golden_blocks(const nlohmann::json& golden) {
    std::vector<IncompleteBlock> blocks;
    for (std::size_t b = 0; b < golden["blocks"].size(); ++b)
        blocks.push_back({golden["blocks"][b].get<std::vector<std::size_t>>(),
                          golden["values"][b].get<std::vector<double>>()});
    return blocks;
}

TEST(Durbin, AgreesWithTheGoldenSet) {
    const auto golden = golden::read_json("sets/anova_sets.json")["durbin"];
    const auto test = durbin(golden_blocks(golden), 7);
    EXPECT_EQ(test.rank_sums, golden["rank_sums"].get<std::vector<double>>());
    EXPECT_NEAR(test.chi_squared, golden["T1"].get<double>(), 1e-13);
    EXPECT_NEAR(test.p / golden["p_chi2"].get<double>(), 1, 1e-13);
    EXPECT_NEAR(test.f, golden["T2_F"].get<double>(), 1e-13);
    EXPECT_NEAR(test.p_f / golden["p_F"].get<double>(), 1, 1e-12);
}

TEST(Durbin, RefusesWhatIsNotBalanced) {
    auto blocks = golden_blocks(golden::read_json("sets/anova_sets.json")["durbin"]);
    blocks.pop_back();
    const auto test = durbin(blocks, 7);
    EXPECT_TRUE(std::isnan(test.p));
    EXPECT_EQ(test.reason, "conditions were ranked by different numbers of observers");
}

} // namespace
