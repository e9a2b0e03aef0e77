// Every case keeps the digits that it holds and that the page claims.
#include "tests/hard_cases/hard_cases.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace {

using hard_cases::Worst;

/// Claimed digits by area and case, as the page has them.
std::map<std::string, double> claims() {
    std::ifstream page(PAIRLIGHT_SOURCE_DIR "/docs/precision-hard-cases.md");
    std::map<std::string, double> digits;
    for (std::string line; std::getline(page, line);) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, '|');)
            cells.push_back(cell);
        if (cells.size() == 9 && cells[7].find_first_of("0123456789") != std::string::npos)
            digits[cells[1] + cells[2]] = std::stod(cells[7]);
    }
    return digits;
}

/// Digits by which another processor may fall short of the page.  Embree asks the processor for its
/// estimate of a reciprocal, and every maker's is another: of what was traced, a last bit in the
/// same place or in two is 0.6 digits.
double allowance(const hard_cases::Case& each) {
    const bool is_traced =
        each.area == "rays" || each.area == "thin shells" || each.area == "coefficients";
    return is_traced ? 0.7 : 0.1;
}

// Beyond 15 digits one last bit, which another processor or library may round otherwise, decides:
// no more than 15 is held of a claim.  The page and the test are one test, so that everything is
// measured once.
TEST(HardCases, KeepTheirDigitsAndThePageClaimsNoMore) {
    const auto claimed = claims();
    const auto cases = hard_cases::measure();
    EXPECT_EQ(claimed.size(), cases.size()) << "write the page again: hard_cases_report";
    for (const auto& each : cases) {
        SCOPED_TRACE(each.area + ": " + each.what);
        EXPECT_GT(each.values, 0);
        EXPECT_GE(each.digits, each.floor) << each.got << " for " << each.expected;
        const auto claim = claimed.find(" " + each.area + "  " + each.what + " ");
        ASSERT_NE(claim, claimed.end()) << "write the page again: hard_cases_report";
        EXPECT_GE(each.digits, std::min(15.0, claim->second - allowance(each)));
    }
}

// The instrument itself: 1.001 is three digits from 1, NaN none, and the worst is what stays.
TEST(HardCases, AreAsGoodAsTheWorstOfTheirValues) {
    Worst worst("a", "b", "c", 0);
    worst.see(2, 2);
    EXPECT_EQ(worst.result().digits, 17);
    worst.see(1.001, 1);
    worst.see(5, 5);
    EXPECT_NEAR(worst.result().digits, 3, 1e-9); // 1.001 - 1 is 0.001 to 1e-13
    EXPECT_EQ(worst.result().got, 1.001);
    EXPECT_EQ(worst.result().values, 3);
    worst.see(std::numeric_limits<double>::quiet_NaN(), 1);
    worst.see(3, 1);
    EXPECT_EQ(worst.result().digits, 0);
    EXPECT_TRUE(std::isnan(worst.result().got));
}

} // namespace
