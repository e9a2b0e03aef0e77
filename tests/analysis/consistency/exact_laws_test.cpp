#include "analysis/consistency/exact_laws.h"
#include "tests/analysis/numerics/golden_table.h"

#include <cmath>

namespace {

using namespace analysis::consistency;

TEST(ExactLaws, TriadsFollowTheEnumeratedCounts) {
    const golden::Table table("circular_triads_exact.csv");
    ASSERT_EQ(table.rows(), 35u);
    std::string k;
    long double sum = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "k") != k)
            sum = 0;
        k = table.text(row, "k");
        sum += table.number(row, "probability");
        EXPECT_NEAR(triads_p(static_cast<std::int64_t>(table.argument(row, "triads")), 1,
                             static_cast<std::int64_t>(table.argument(row, "k"))),
                    static_cast<double>(sum), 1e-14);
    }
}

// What published tables give for n rounds of four: at most 4 of 9, 19 of 27 at 5 %.
TEST(ExactLaws, TriadsOfManyRoundsAreConvolved) {
    EXPECT_NEAR(triads_p(4, 9, 4), 0.041, 0.0005);
    EXPECT_NEAR(triads_p(2, 9, 4), 0.0047, 0.00005);
    EXPECT_NEAR(triads_p(19, 27, 4), 0.048, 0.0005);
    EXPECT_NEAR(triads_p(1, 2, 3), 1 - 1.0 / 16, 1e-15);
    EXPECT_TRUE(std::isnan(triads_p(0, 3, 2)));
    EXPECT_TRUE(std::isnan(triads_p(0, 0, 4)));
}

// At eight conditions the chi-squared form begins.  No triad at all among nine has probability
// 9! / 2^36 = 5.3e-6; the approximation is not that good so far out, but on the safe side.
TEST(ExactLaws, ManyConditionsUseTheApproximations) {
    EXPECT_LT(triads_p(0, 1, 9), 1e-4);
    EXPECT_GT(triads_p(0, 1, 9), 5.2e-6);
    EXPECT_GT(triads_p(21, 1, 9), 0.4);
    EXPECT_LT(triads_p(10, 5, 9), 1e-10);
}

TEST(ExactLaws, RangesOfTotalsAgreeWithTheGoldenTable) {
    const golden::Table table("david_range_exact_null.csv");
    ASSERT_GT(table.rows(), 150u);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto p = range_p_exact(static_cast<std::int64_t>(table.argument(row, "R")),
                                     static_cast<std::int64_t>(table.argument(row, "m")),
                                     static_cast<std::int64_t>(table.argument(row, "t")));
        if (table.argument(row, "t") > 4 || table.argument(row, "m") > 20) {
            EXPECT_FALSE(p);
            continue;
        }
        ASSERT_TRUE(p);
        EXPECT_NEAR(*p, table.argument(row, "P_range_at_least_R"), 2e-14) << row;
    }
}

// All 2^n sequences, counted.
TEST(ExactLaws, LongestRunsAgreeWithEnumeration) {
    for (int n = 1; n <= 12; ++n) {
        std::vector<int> with(static_cast<std::size_t>(n) + 2, 0);
        for (unsigned sequence = 0; sequence < 1U << n; ++sequence) {
            int longest = 1, run = 1;
            for (int i = 1; i < n; ++i) {
                run = (sequence >> i & 1U) == (sequence >> (i - 1) & 1U) ? run + 1 : 1;
                longest = std::max(longest, run);
            }
            ++with[static_cast<std::size_t>(longest)];
        }
        int so_long = 0;
        for (int length = n + 1; length >= 1; --length) {
            so_long += with[static_cast<std::size_t>(length)];
            EXPECT_NEAR(longest_run_p(length, n), std::ldexp(so_long, -n), 1e-14)
                << length << " of " << n;
        }
    }
}

} // namespace
