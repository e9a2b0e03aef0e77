#include "analysis/consistency/rank_tests.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/numerics/golden_json.h"

#include <cmath>

namespace {

using analysis::consistency::friedman;
using nlohmann::json;

std::vector<std::int64_t> flat(const json& blocks) {
    std::vector<std::int64_t> values;
    for (const auto& block : blocks)
        for (const auto& value : block)
            values.push_back(value.get<std::int64_t>());
    return values;
}

TEST(Friedman, AgreesWithTheGoldenSetThatHasTies) {
    const auto golden = golden::read_json("sets/anova_sets.json")["friedman_ties"];
    const auto test = friedman(flat(golden["blocks"]), 5);
    EXPECT_EQ(test.rank_sums, golden["rank_sums"].get<std::vector<double>>());
    EXPECT_DOUBLE_EQ(test.chi_squared, golden["chi2"].get<double>());
    EXPECT_DOUBLE_EQ(test.kendall_w, golden["kendall_W"].get<double>());
    EXPECT_DOUBLE_EQ(test.f, golden["iman_davenport_F"].get<double>());
    EXPECT_NEAR(test.p_f, golden["p_F"].get<double>(), 1e-13);
    EXPECT_NEAR(test.p, golden["p"].get<double>(), 1e-13);
}

TEST(Friedman, SaysWhatPerfectAgreementAndAllTiesMean) {
    const auto golden = golden::read_json("hard_cases.json")["friedman"];
    const auto perfect = friedman(flat(golden["perfect"]["blocks"]), 3);
    EXPECT_EQ(perfect.kendall_w, 1);
    EXPECT_EQ(perfect.chi_squared, 10);
    EXPECT_TRUE(std::isnan(perfect.f));
    const auto tied = friedman(flat(golden["all_tied"]["blocks"]), 3);
    EXPECT_TRUE(std::isnan(tied.p));
    EXPECT_EQ(tied.reason, "0/0: every observer's scores are all tied");
}

} // namespace
