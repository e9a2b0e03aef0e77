#include "analysis/numerics/decimal.h"

#include <string>
#include <utility>
#include <vector>

namespace {

using analysis::numerics::Decimal;
using analysis::numerics::parse_decimal;

void expect_decimal(const std::string& text, long long mantissa, int exponent) {
    const auto value = parse_decimal(text);
    ASSERT_TRUE(value) << value.error();
    EXPECT_TRUE(value->mantissa == mantissa) << text;
    EXPECT_EQ(value->exponent, exponent) << text;
}

TEST(Decimal, KeepsTheDigitsAsTheyStand) {
    expect_decimal("0.1", 1, -1);
    expect_decimal("1000000000000.4", 10000000000004, -1);
    expect_decimal("-00.50", -50, -2);
    expect_decimal("+.5", 5, -1);
    expect_decimal("7.", 7, 0);
    expect_decimal("5.11462616000000E-02", 511462616000000, -16);
    expect_decimal("1e-160", 1, -160);
    expect_decimal("0", 0, 0);
}

TEST(Decimal, HoldsThirtyEightDigits) {
    const auto value = parse_decimal("12345678901234567890.123456789012345678");
    ASSERT_TRUE(value);
    EXPECT_EQ(static_cast<long long>(value->mantissa % 1000000000), 12345678);
    EXPECT_EQ(value->exponent, -18);
}

TEST(Decimal, RefusesWhatIsNotANumberAndSaysWhere) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "'', column 1: found nothing, expected a digit"},
        {"-", "'-', column 2: found nothing, expected a digit"},
        {".", "'.', column 2: found nothing, expected a digit"},
        {"1,5", "'1,5', column 2: found ',', expected the end of a number"},
        {"1.2.3", "'1.2.3', column 4: found '.', expected the end of a number"},
        {" 1", "' 1', column 1: found ' ', expected a digit"},
        {"0x10", "'0x10', column 2: found 'x', expected the end of a number"},
        {"2e", "'2e', column 3: found nothing, expected a digit of the exponent"},
        {"nan", "'nan', column 1: found 'n', expected a digit"},
        {"123456789012345678901234567890123456789",
         "'123456789012345678901234567890123456789' has 39 digits, expected at most 38"},
        {"1e99999", "'1e99999' has exponent 99999, expected between -4000 and 4000"},
    };
    for (const auto& [text, message] : cases) {
        const auto value = parse_decimal(text);
        ASSERT_FALSE(value) << text;
        EXPECT_EQ(value.error(), message);
    }
}

} // namespace
