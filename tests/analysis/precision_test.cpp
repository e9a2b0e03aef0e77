// The committed page claims what the program measures today.
#include "tests/analysis/precision.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace {

// Claimed digits by quantity, as the page has them.
std::map<std::string, double> claims() {
    std::ifstream page(PAIRLIGHT_SOURCE_DIR "/docs/precision.md");
    std::map<std::string, double> digits;
    for (std::string line; std::getline(page, line);) {
        std::istringstream cells(line);
        std::string empty, what, reference, values, claimed;
        std::getline(cells, empty, '|');
        std::getline(cells, what, '|');
        std::getline(cells, reference, '|');
        std::getline(cells, values, '|');
        std::getline(cells, claimed, '|');
        if (!claimed.empty() && claimed.find_first_of("0123456789") != std::string::npos)
            digits[what.substr(1, what.size() - 2)] = std::stod(claimed);
    }
    return digits;
}

// Beyond 15 digits one last bit, which another processor or library may round otherwise, decides:
// no more than 15 is held there, and a tenth is allowed elsewhere.
TEST(PrecisionPage, ClaimsNoMoreThanIsMeasured) {
    auto claimed = claims();
    const auto rows = precision::measure();
    ASSERT_EQ(claimed.size(), rows.size()) << "write the page again: precision_report";
    for (const auto& row : rows) {
        ASSERT_TRUE(claimed.contains(row.what)) << row.what;
        EXPECT_GE(row.digits, std::min(15.0, claimed[row.what] - 0.1)) << row.what;
        EXPECT_GT(row.values, 0) << row.what;
    }
}

} // namespace
