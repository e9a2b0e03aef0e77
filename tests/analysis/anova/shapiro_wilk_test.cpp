#include "analysis/anova/shapiro_wilk.h"
#include "tests/analysis/golden.h"

#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace {

using analysis::anova::shapiro_wilk;

std::vector<std::vector<std::string>> table(const std::string& path) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream stream(golden_text(path));
    std::string line, field;
    std::getline(stream, line);
    while (std::getline(stream, line)) {
        std::istringstream fields(line);
        rows.emplace_back();
        while (std::getline(fields, field, ','))
            rows.back().push_back(field);
    }
    return rows;
}

// R is the standard (its own approximation is good to 1e-7): W to 1e-12, p to 1e-9 relative.
TEST(ShapiroWilk, AgreesWithTheGoldenSamples) {
    std::map<std::string, std::vector<double>> samples;
    for (const auto& row : table("sets/shapiro_inputs.csv"))
        samples[row[0]].push_back(std::stod(row[2]));
    std::size_t compared = 0;
    for (const auto& row : table("sets/shapiro.csv")) {
        const auto& id = row[0];
        // R loses eight digits on the sample with an offset; the README has the true figures.
        const bool offset = id == "offset1e9_20";
        const double w = offset ? 0.91757037220334 : std::stod(row[2]);
        const double p = offset ? 0.08897774040888 : std::stod(row[3]);
        const auto test = shapiro_wilk(samples.at(id));
        EXPECT_LE(std::abs(test.w - w), 1e-12) << id;
        EXPECT_LE(std::abs(test.p - p), (offset ? 1e-8 : 1e-9) * p) << id;
        ++compared;
    }
    EXPECT_EQ(compared, 31u);
}

TEST(ShapiroWilk, SaysWhenItCannot) {
    EXPECT_EQ(shapiro_wilk(std::vector{1.0, 2.0}).reason, "needs at least 3 values");
    EXPECT_EQ(shapiro_wilk(std::vector{4.0, 4.0, 4.0}).reason, "all values are equal");
    const auto three = shapiro_wilk(std::vector{1.0, 2.0, 3.0});
    EXPECT_NEAR(three.w, 1, 1e-15);
    EXPECT_NEAR(three.p, 1, 1e-7); // arcsine near 1 turns 1e-16 into its root
}

} // namespace
