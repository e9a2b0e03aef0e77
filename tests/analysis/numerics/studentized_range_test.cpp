#include "analysis/numerics/studentized_range.h"
#include "tests/analysis/numerics/golden_table.h"

#include <limits>
#include <map>
#include <string>

namespace {

using namespace analysis::numerics;
using golden::Table;
using golden::Worst;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string region_of(long double p) {
    return p > 0.5L ? "p > 1/2" : p > 1e-16L ? "p > 1e-16" : p > 1e-300L ? "p > 1e-300" : "below";
}

// Above 1e-16 we ask 1e-13, below 1e-12, of p or, where a double ends, of its logarithm.
void expect_tail(Worst& worst,
                 const std::string& side,
                 const Tail& tail,
                 long double p,
                 const std::string& where) {
    const long double tolerance = p > 1e-16L ? 1e-13L : 1e-12L;
    if (p > 1e-300L) {
        EXPECT_LE(worst.see(side + " " + region_of(p), tail.p, p), tolerance) << where;
    } else if (p > 0) {
        EXPECT_LE(worst.see(side + " log10", tail.log10_p, std::log10(p)), tolerance) << where;
    }
}

TEST(StudentizedRange, MatchesTheGoldenTails) {
    const Table table("ptukey.csv");
    ASSERT_EQ(table.rows(), 1328u);
    Worst worst("range");
    std::map<double, StudentizedRanges> ranges;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const double k = table.argument(i, "k"), df = table.argument(i, "df");
        const double q = table.argument(i, "q");
        const auto where =
            "k " + table.text(i, "k") + ", df " + table.text(i, "df") + ", q " + table.text(i, "q");
        expect_tail(worst, "upper", studentized_range_upper_tail(q, k, df),
                    table.number(i, "upper"), where);
        expect_tail(worst, "lower", studentized_range_lower_tail(q, k, df),
                    table.number(i, "lower"), where);
        auto& many = ranges.try_emplace(k, k).first->second;
        expect_tail(worst, "shared", many.upper_tail(q, df), table.number(i, "upper"), where);
    }
}

TEST(StudentizedRange, MatchesTheGoldenQuantiles) {
    const Table table("qtukey.csv");
    ASSERT_EQ(table.rows(), 569u);
    Worst worst("range quantile");
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const double k = table.argument(i, "k"), df = table.argument(i, "df");
        const double p = table.argument(i, "p_upper");
        EXPECT_LE(worst.see("p " + table.text(i, "p_upper"), studentized_range_quantile(p, k, df),
                            table.number(i, "q")),
                  1e-13L)
            << "k " << table.text(i, "k") << ", df " << table.text(i, "df") << ", p "
            << table.text(i, "p_upper");
    }
}

// Two means: the range over sqrt2 is Student's t, of any real degrees of freedom.
TEST(StudentizedRange, OfTwoIsStudentsT) {
    for (const double df : {0.3, 1.0, 2.7, 39.9, 40.1, 79.9, 80.1, 1e3, 1e6, 1e9, infinity})
        for (const double q : {0.01, 1.0, 4.0, 12.0, 60.0}) {
            const Tail expected = t_two_sided(q / std::sqrt(2.0), df);
            const Tail tail = studentized_range_upper_tail(q, 2, df);
            // q / sqrt2 is rounded: times the slope of ln p in ln q, at most q^2 / 2 and df.
            const double rounding = 2e-16 * std::min(df, q * q / 2);
            if (expected.p > 1e-300) {
                EXPECT_NEAR(tail.p / expected.p, 1, 2e-14 + rounding) << df << ", " << q;
            }
            EXPECT_NEAR(tail.log10_p, expected.log10_p, 1e-14 + 1e-13 * -expected.log10_p);
        }
}

TEST(StudentizedRange, HalvingBothStepsChangesNothing) {
    for (const double k : {2.0, 4.0, 13.0, 30.0, 200.0})
        for (const double df : {0.5, 3.0, 36.0, 1e5, infinity})
            for (const double q : {0.2, 3.0, 9.0, 25.0}) {
                const auto where = testing::Message() << k << ", " << df << ", " << q;
                const double upper = studentized_range_upper_tail(q, k, df).log10_p;
                const double lower = studentized_range_lower_tail(q, k, df).log10_p;
                const double bound = 1e-13; // of log10 p: a relative 2.3e-13 of p
                EXPECT_NEAR(studentized_range_upper_tail(q, k, df, 0.5).log10_p, upper, bound)
                    << where;
                EXPECT_NEAR(studentized_range_lower_tail(q, k, df, 0.5).log10_p, lower, bound)
                    << where;
            }
}

// From a certain q to p = 1e-300, few and many conditions, few and many degrees of freedom, in runs
// and in turns.  Both have an error of about 1e-15, in log10 p where p is small.
TEST(StudentizedRange, ManyTailsTogetherAreThoseOfEachAlone) {
    double worst = 0;
    int compared = 0;
    for (const double k : {2.0, 4.0, 8.0, 30.0, 100.0, 400.0}) {
        StudentizedRanges together(k);
        for (const double df : {2.0, 17.3, 27.0, 891.0, infinity})
            for (double q = 0.01; q < 60; q = q * 1.17 + 0.03) {
                const auto alone = studentized_range_upper_tail(q, k, df);
                const auto shared = together.upper_tail(q, df);
                const double off = std::abs(shared.log10_p - alone.log10_p) /
                                   std::max(1.0, std::abs(alone.log10_p));
                EXPECT_LE(off, 1e-14) << k << ", " << df << ", " << q << ": " << alone.p;
                worst = std::max(worst, off);
                ++compared;
            }
    }
    EXPECT_GT(compared, 900);
    EXPECT_GT(worst, 0); // else one would call the other
    StudentizedRanges ranges(3);
    EXPECT_TRUE(std::isnan(ranges.upper_tail(std::nan(""), 5).p));
    EXPECT_EQ(ranges.upper_tail(0, 5).p, 1);
    EXPECT_EQ(ranges.upper_tail(infinity, 5).p, 0);
}

TEST(StudentizedRange, TailsAddUpToOne) {
    for (const double k : {2.0, 5.0, 20.0, 50.5})
        for (const double df : {0.7, 12.0, 500.0, infinity})
            for (const double q : {0.5, 2.0, 4.5, 8.9, 9.1, 29.9, 30.1})
                EXPECT_NEAR(studentized_range_upper_tail(q, k, df).p +
                                studentized_range_lower_tail(q, k, df).p,
                            1, 4e-15)
                    << k << ", " << df << ", " << q;
}

// Where p underflows the union bound over the pairs is exact: a closed form.
TEST(StudentizedRange, KeepsItsLogarithmWherePUnderflows) {
    const Tail tail = studentized_range_upper_tail(60, 5, infinity);
    EXPECT_EQ(tail.p, 0.0);
    const double expected =
        (std::log(20.0) + log_normal_cdf(-60 / std::sqrt(2.0))) / std::log(10.0);
    EXPECT_NEAR(tail.log10_p / expected, 1, 1e-15);
    // df = 2000 and q = 1e4: below 1e-3000, but k = 2 is still Student's t.
    EXPECT_NEAR(studentized_range_upper_tail(1e4, 2, 2000).log10_p /
                    t_two_sided(1e4 / std::sqrt(2.0), 2000).log10_p,
                1, 1e-14);
}

TEST(StudentizedRange, QuantileInvertsTheTail) {
    for (const double k : {2.0, 6.0, 40.0})
        for (const double df : {0.5, 4.0, 27.0, 1e7, infinity})
            for (const double p : {0.999999, 0.95, 0.5, 0.05, 1e-7, 1e-30, 1e-60}) {
                const double q = studentized_range_quantile(p, k, df);
                if (p > 0.5) {
                    EXPECT_NEAR(studentized_range_lower_tail(q, k, df).p / (1 - p), 1, 1e-12);
                } else { // a few roundings of q, times the slope of ln p, which reaches q^2 / 2
                    const double rounding = 3e-15 * std::min(df, q * q / 2);
                    EXPECT_NEAR(studentized_range_upper_tail(q, k, df).p / p, 1, 1e-13 + rounding)
                        << k << ", " << df << ", " << p;
                }
            }
}

TEST(StudentizedRange, HasItsLimits) {
    EXPECT_EQ(studentized_range_upper_tail(0, 3, 20).p, 1.0);
    EXPECT_EQ(studentized_range_lower_tail(0, 3, 20).p, 0.0);
    EXPECT_EQ(studentized_range_upper_tail(infinity, 3, 20).p, 0.0);
    EXPECT_EQ(studentized_range_lower_tail(infinity, 3, 20).p, 1.0);
    EXPECT_TRUE(std::isnan(studentized_range_upper_tail(std::nan(""), 3, 20).p));
}

// Figures other programs were seen to lose.
TEST(StudentizedRange, KnowsTheHardCases) {
    EXPECT_NEAR(studentized_range_upper_tail(17.43559577416269, 4, 36).p / 1.0434001607007184e-13,
                1, 1e-14);                                                          // R: 0
    EXPECT_NEAR(studentized_range_upper_tail(10000, 2, 2).p, 1.99999994e-8, 1e-16); // scipy: 0
}

} // namespace
