#include "experiment/report/numbers.h"

#include <cmath>
#include <limits>

namespace {

using namespace experiment::report;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Numbers, HaveARealMinusAndNoNegativeZero) {
    EXPECT_EQ(decimal(2.16667, 2), "2.17");
    EXPECT_EQ(decimal(-0.5, 2), "\u22120.50");
    EXPECT_EQ(decimal(-0.0001, 2), "0.00");
    EXPECT_EQ(decimal(-10, 0), "\u221210");
}

TEST(Numbers, ThatAreNotDefinedAreADash) {
    EXPECT_EQ(decimal(std::nan(""), 2), no_number);
    EXPECT_EQ(significant(std::nan(""), 2), no_number);
    EXPECT_EQ(p_value(std::nan("")), no_number);
    EXPECT_EQ(percent(std::nan("")), no_number);
    EXPECT_EQ(significant(infinity, 4), "\u221e");
}

TEST(Numbers, KeepTheirSignificantDigits) {
    EXPECT_EQ(significant(59.342245989304814, 4), "59.34");
    EXPECT_EQ(significant(3, 4), "3.000");
    EXPECT_EQ(significant(0.00412345, 2), "0.0041");
    EXPECT_EQ(significant(123456.7, 4), "123457");
    EXPECT_EQ(significant(1.5e-7, 2), "1.5\u00a0\u00d7\u00a010\u207b\u2077");
    EXPECT_EQ(significant(0, 4), "0");
}

TEST(DegreesOfFreedom, AreWholeWhereTheyAre) {
    EXPECT_EQ(degrees(27), "27");
    EXPECT_EQ(degrees(17.4312), "17.43");
}

TEST(PValues, AreThreeDecimalsDownToOneInAThousand) {
    EXPECT_EQ(p_value(0.0333), "0.033");
    EXPECT_EQ(p_value(1), "1.000");
    EXPECT_EQ(p_value(0.001), "0.001");
    EXPECT_EQ(p_value(5.187e-12), "5.2\u00a0\u00d7\u00a010\u207b\u00b9\u00b2");
    EXPECT_EQ(p_value(9.96e-5), "1.0\u00a0\u00d7\u00a010\u207b\u2074");
    EXPECT_EQ(p_equals(0.5), "p\u00a0=\u00a00.500");
}

TEST(PValues, BelowTheRangeOfDoublesSpeakByTheirLogarithm) {
    EXPECT_EQ(p_value(0, -1234.5), "3.2\u00a0\u00d7\u00a010\u207b\u00b9\u00b2\u00b3\u2075");
    EXPECT_EQ(p_value(0, -400.001), "1.0\u00a0\u00d7\u00a010\u207b\u2074\u2070\u2070");
    EXPECT_EQ(p_value(0, -infinity), "0"); // no error variation at all
}

TEST(Votes, MayBeHalves) {
    EXPECT_EQ(votes(585), "585");
    EXPECT_EQ(votes(12.5), "12.5");
}

TEST(Numbers, AreGroupedByThousands) {
    EXPECT_EQ(grouped(7), "7");
    EXPECT_EQ(grouped(1620), "1\u202f620");
    EXPECT_EQ(grouped(1234567), "1\u202f234\u202f567");
    EXPECT_EQ(grouped(-999), "\u2212999");
}

TEST(Shares, AreWholePercent) {
    EXPECT_EQ(percent(0.7222), "72\u00a0%");
}

} // namespace
