#include "analysis/anova/one_way.h"
#include "analysis/numerics/nist_file.h"

#include <cmath>
#include <fstream>
#include <iterator>

namespace {

using namespace analysis::anova;

TEST(OneWay, CountsAndRealsAgree) {
    const std::vector<std::vector<std::int64_t>> counts{{3, 5, 4, 8}, {1, 0, 2, 2}, {9, 7, 9, 8}};
    std::vector<std::vector<double>> reals;
    for (const auto& group : counts) {
        reals.emplace_back();
        for (const auto value : group)
            reals.back().push_back(static_cast<double>(value) / 2);
    }
    const auto exact = one_way_of_counts(counts, 2), real = one_way(reals);
    EXPECT_DOUBLE_EQ(exact.test.f, real.test.f);
    EXPECT_DOUBLE_EQ(exact.between.ss, real.between.ss);
    EXPECT_DOUBLE_EQ(exact.within.ss, real.within.ss);
    EXPECT_DOUBLE_EQ(exact.omega_squared, real.omega_squared);
    EXPECT_DOUBLE_EQ(exact.grand_mean, real.grand_mean);
    EXPECT_DOUBLE_EQ(exact.variance[2], real.variance[2]);
}

TEST(OneWay, FarFromZeroItKeepsItsDigits) {
    const std::vector<std::vector<double>> groups{{1e15 + 1, 1e15 + 2, 1e15 + 3},
                                                  {1e15 + 2, 1e15 + 3, 1e15 + 4},
                                                  {1e15 + 5, 1e15 + 6, 1e15 + 7}};
    const auto table = one_way(groups);
    EXPECT_DOUBLE_EQ(table.between.ss, 26);
    EXPECT_DOUBLE_EQ(table.within.ss, 6);
    EXPECT_DOUBLE_EQ(table.test.f, 13);
    EXPECT_NEAR(table.test.p, 6.591796875e-3, 1e-16);
}

// What rounding 1000000000000.4 to a double leaves of NIST's hardest sets, in exact arithmetic of
// the rounded values: the certified F are 21, 201 and 2001, and no program that reads doubles gets
// them.
TEST(OneWay, OfRoundedDataIsExactForWhatTheyBecame) {
    const std::pair<const char*, double> sets[] = {
        {"SmLs07", 21.0008118878}, {"SmLs08", 201.0130040959}, {"SmLs09", 2001.1349262209}};
    for (const auto& [name, f] : sets) {
        std::ifstream file(PAIRLIGHT_TEST_DATA "/nist/" + std::string(name) + ".dat");
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const auto set = analysis::numerics::read_nist_one_way(text, name).value();
        std::vector<std::vector<double>> groups;
        for (const auto& group : set.groups) {
            groups.emplace_back();
            for (const auto& value : group) {
                ASSERT_TRUE(value.exponent == 0 || value.exponent == -1);
                groups.back().push_back(static_cast<double>(value.mantissa) /
                                        (value.exponent == 0 ? 1 : 10));
            }
        }
        // Half of the tenth decimal, the last that stands there, and fifteen digits.
        EXPECT_LE(std::abs(one_way(groups).test.f - f), 0.5e-10 + 1e-15 * f) << name;
    }
}

TEST(OneWay, AnExactFitIsInfiniteAndNothingAtAllIsUndefined) {
    const auto exact = one_way(std::vector<std::vector<double>>{{1, 1}, {2, 2}, {4, 4}});
    EXPECT_EQ(exact.test.outcome, Outcome::Infinite);
    EXPECT_TRUE(std::isinf(exact.test.f));
    EXPECT_EQ(exact.test.p, 0);
    EXPECT_EQ(exact.eta_squared, 1);
    const auto nothing = one_way(std::vector<std::vector<double>>{{0.1, 0.1}, {0.1, 0.1, 0.1}});
    EXPECT_EQ(nothing.test.outcome, Outcome::Undefined);
    EXPECT_TRUE(std::isnan(nothing.test.f));
    EXPECT_EQ(nothing.test.reason, "0/0: neither the effect nor the error varies");
}

TEST(OneWay, OneValuePerGroupLeavesNothingToTestWith) {
    const auto table = one_way(std::vector<std::vector<double>>{{1}, {2}});
    EXPECT_EQ(table.test.outcome, Outcome::Undefined);
    EXPECT_EQ(table.test.reason, "no degrees of freedom are left to test with");
}

} // namespace
