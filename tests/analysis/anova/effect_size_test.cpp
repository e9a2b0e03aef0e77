#include "analysis/anova/effect_size.h"
#include "analysis/numerics/distributions.h"
#include "analysis/numerics/noncentrality.h"
#include "tests/analysis/numerics/golden_table.h"

#include <cmath>

namespace {

using namespace analysis;

TEST(Noncentrality, PutsTheGoldenTableBack) {
    const golden::Table table("noncentral_f.csv");
    ASSERT_EQ(table.rows(), 7u);
    golden::Worst worst("noncentrality");
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const double lambda =
            numerics::noncentrality(table.argument(i, "F"), table.argument(i, "df1"),
                                    table.argument(i, "df2"), table.argument(i, "power"));
        // Where power is 1 - 4e-10 its own last digit moves lambda by 1e-8.
        const double tolerance = table.argument(i, "cdf") < 1e-5 ? 1e-7 : 1e-11;
        EXPECT_LE(worst.see("lambda", lambda, table.number(i, "lambda")), tolerance) << i;
    }
}

TEST(EffectSize, BoundsAreWhereFIsJustNotSurprising) {
    const auto [lower, upper] = anova::eta_squared_interval(59.342245989304814, 3, 27, 0.95);
    const auto lambda = [](double eta) { return eta / (1 - eta) * (3 + 27 + 1); };
    EXPECT_NEAR(numerics::noncentral_f_upper_tail(59.342245989304814, 3, 27, lambda(lower)).p,
                0.025, 1e-12);
    EXPECT_NEAR(numerics::noncentral_f_lower_tail(59.342245989304814, 3, 27, lambda(upper)).p,
                0.025, 1e-12);
    EXPECT_LT(lower, 0.868); // the estimate, 3 F / (3 F + 27)
    EXPECT_GT(upper, 0.868);
}

TEST(EffectSize, AnUnremarkableFReachesDownToZero) {
    const auto [lower, upper] = anova::eta_squared_interval(0.5, 3, 27, 0.95);
    EXPECT_EQ(lower, 0);
    EXPECT_GT(upper, 0);
    EXPECT_TRUE(std::isnan(anova::eta_squared_interval(HUGE_VAL, 3, 27, 0.95).lower));
}

} // namespace
