#include "analysis/anova/adjustments.h"
#include "tests/analysis/numerics/golden_json.h"

#include <cmath>

namespace {

using nlohmann::json;
using namespace analysis::anova;

std::vector<double> numbers(const json& list) {
    std::vector<double> values;
    for (const auto& item : list)
        values.push_back(item.is_string() ? std::stod(item.get<std::string>())
                                          : item.get<double>());
    return values;
}

TEST(Adjustments, AgreeWithTheGoldenOnesAlsoWhenTied) {
    const auto golden = golden::read_json("hard_cases.json")["adjust"];
    const auto p = numbers(golden["p"]);
    const auto near = [](const json& list) {
        return testing::Pointwise(testing::DoubleEq(), numbers(list));
    };
    EXPECT_THAT(bonferroni(p), near(golden["bonferroni"]));
    EXPECT_THAT(holm(p), near(golden["holm"]));
    EXPECT_THAT(hochberg(p), near(golden["hochberg"]));
    EXPECT_THAT(benjamini_hochberg(p), near(golden["bh"]));
    EXPECT_THAT(holm(numbers(golden["p2"])), near(golden["holm2"]));
}

TEST(Adjustments, UndefinedStaysUndefinedAndDoesNotCount) {
    const std::vector<double> p{0.01, std::nan(""), 0.04};
    EXPECT_EQ(holm(p)[0], 0.02);
    EXPECT_TRUE(std::isnan(holm(p)[1]));
    EXPECT_TRUE(std::isnan(benjamini_hochberg(p)[1]));
    EXPECT_EQ(bonferroni(p)[2], 0.08);
}

} // namespace
