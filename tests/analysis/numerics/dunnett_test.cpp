#include "analysis/numerics/dunnett.h"
#include "tests/analysis/numerics/golden_table.h"

#include <limits>

namespace {

using namespace analysis::numerics;

// For equal groups: n / (n + n) under the root.
std::vector<double> equal(std::size_t comparisons) {
    return std::vector<double>(comparisons, std::sqrt(0.5));
}

double df_of(const golden::Table& table, std::size_t row) {
    return table.text(row, "df") == "inf" ? std::numeric_limits<double>::infinity()
                                          : table.argument(row, "df");
}

TEST(Dunnett, HasThirteenDigitsOfTheGoldenTable) {
    const golden::Table table("dunnett_two_sided.csv");
    ASSERT_EQ(table.rows(), 10u);
    golden::Worst worst("Dunnett");
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const auto loading = equal(static_cast<std::size_t>(table.argument(i, "comparisons")));
        const double p = dunnett_upper_tail(table.argument(i, "abs_t"), loading, df_of(table, i)).p;
        EXPECT_LE(worst.see("p", p, table.number(i, "upper")), 1e-13L) << i;
    }
}

TEST(Dunnett, OfOneComparisonIsT) {
    for (const double t : {0.1, 1.0, 3.0, 20.0})
        for (const double df : {1.5, 10.0, 200.0})
            EXPECT_NEAR(dunnett_upper_tail(t, equal(1), df).p / t_two_sided(t, df).p, 1, 1e-12)
                << t << ' ' << df;
}

TEST(Dunnett, QuantilesPutTheProbabilityBack) {
    const std::vector<double> uneven{0.3, 0.7, 0.9};
    for (const double p : {0.5, 0.05, 1e-6}) {
        const double c = dunnett_quantile(p, uneven, 12);
        EXPECT_NEAR(dunnett_upper_tail(c, uneven, 12).p / p, 1, 1e-11) << p;
    }
}

// With a known deviation and a control without error (loading 0) the comparisons are independent.
TEST(Dunnett, AlmostIndependentComparisonsMultiply) {
    const std::vector<double> loading(3, 1e-6);
    const double one = 2 * normal_upper_tail(2.0).p;
    EXPECT_NEAR(dunnett_upper_tail(2.0, loading, std::numeric_limits<double>::infinity()).p,
                1 - std::pow(1 - one, 3), 1e-11);
}

} // namespace
