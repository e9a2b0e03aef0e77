#include "analysis/anova/comparisons.h"
#include "tests/analysis/golden.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

namespace {

using nlohmann::json;
using namespace analysis::anova;

std::vector<std::vector<double>> unequal_groups() {
    std::istringstream stream(golden_text("sets/unequal_1way.csv"));
    std::vector<std::vector<double>> groups(4);
    std::string line;
    std::getline(stream, line);
    while (std::getline(stream, line))
        groups.at(static_cast<std::size_t>(line[1] - '1')).push_back(std::stod(line.substr(3)));
    return groups;
}

void expect_near(const json& expected, double found, double tolerance) {
    EXPECT_LE(std::abs(found - expected.get<double>()),
              tolerance * std::abs(expected.get<double>()))
        << expected.dump() << " " << found;
}

// Decimals were rounded to doubles on the way in, which costs F about two digits of sixteen.
TEST(Comparisons, OfUnequalGroupsAgreeWithTheGoldenSet) {
    const auto golden = json::parse(golden_text("sets/anova_sets.json"))["unequal_1way"];
    const auto table = one_way(unequal_groups());
    expect_near(golden["anova"]["F"], table.test.f, 1e-13);
    expect_near(golden["anova"]["p"], table.test.p, 1e-13);
    expect_near(golden["anova"]["omega2"], table.omega_squared, 1e-12);
    const auto test = tukey(table.mean, table.n, table.within);
    EXPECT_TRUE(std::isnan(test.comparison_half_width)); // only equal sizes have one
    expect_near(golden["tukey_kramer"]["q_crit"], test.q_critical, 1e-12);
    ASSERT_EQ(golden["tukey_kramer"]["pairs"].size(), test.pairs.size());
    for (std::size_t i = 0; i < test.pairs.size(); ++i) {
        const auto& pair = golden["tukey_kramer"]["pairs"][i];
        expect_near(pair["q"], test.pairs[i].q, 1e-13);
        expect_near(pair["p"], test.pairs[i].p, 1e-12);
        expect_near(pair["lower"], test.pairs[i].lower, 1e-12);
    }
    const auto own_variances = games_howell(table);
    ASSERT_EQ(golden["games_howell"].size(), own_variances.size());
    for (std::size_t i = 0; i < own_variances.size(); ++i) {
        expect_near(golden["games_howell"][i]["df"], own_variances[i].df, 1e-12);
        expect_near(golden["games_howell"][i]["p"], own_variances[i].p, 1e-12);
    }
}

TEST(Comparisons, WithoutErrorVariationDifferencesAreCertainAndEqualityUndefined) {
    const std::vector<double> means{1, 1, 2};
    const std::vector<std::int64_t> sizes{3, 3, 3};
    const auto test = tukey(means, sizes, {0, 6});
    EXPECT_TRUE(std::isnan(test.pairs[0].p)); // 0/0
    EXPECT_FALSE(test.pairs[0].significant);
    EXPECT_EQ(test.pairs[1].p, 0);
    EXPECT_TRUE(test.pairs[1].significant);
}

TEST(Comparisons, PairedTOfConstantDifferencesIsDecidedInIntegers) {
    const std::vector<std::int64_t> counts{7, 4, 4, 5, 2, 2, 9, 6, 6}; // 3 observers x 3
    const auto pairs = paired_t(counts, 3, 3);
    EXPECT_EQ(pairs[0].p, 0); // always 3 more
    EXPECT_TRUE(std::isnan(pairs[2].p));
    EXPECT_EQ(pairs[0].difference, 1);
}

} // namespace
