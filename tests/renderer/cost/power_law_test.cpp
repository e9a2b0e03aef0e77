#include "renderer/cost/power_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace renderer::cost;

// y = 3 x^1.5: logarithms round to 1e-16 of themselves, which are below 10.
TEST(PowerLaw, FindsTheExponentOfOne) {
    const std::vector<double> x{1, 2, 10, 700};
    std::vector<double> y;
    for (const double value : x)
        y.push_back(3 * std::pow(value, 1.5));
    const auto law = fit_power_law(x, y);
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->exponent, 1.5, 1e-14);
    EXPECT_NEAR(law->factor, 3, 1e-13);
    EXPECT_NEAR(law->standard_error, 0, 1e-14);
    EXPECT_NEAR(law->worst_ratio, 1, 1e-14);
    EXPECT_EQ(law->points, 4U);
}

// Logarithms (0, 0), (1, 1), (2, 1), by hand: slope 1/2, rests -1/6, 1/3, -1/6; their squares add
// up to 1/6, one degree of freedom, sum of (u - 1)^2 is 2: standard error sqrt(1/12).
TEST(PowerLaw, HasTheStandardErrorOfItsSlope) {
    const double e = std::exp(1.0);
    const auto law = fit_power_law(std::vector{1.0, e, e * e}, std::vector{1.0, e, e});
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->exponent, 0.5, 1e-15);
    EXPECT_NEAR(law->standard_error, std::sqrt(1.0 / 12), 1e-15);
    EXPECT_NEAR(law->worst_ratio, std::exp(1.0 / 3), 1e-15);
}

TEST(PowerLaw, RefusesWhatHasNone) {
    EXPECT_FALSE(fit_power_law(std::vector{1.0, 2.0}, std::vector{1.0, 2.0}));
    EXPECT_FALSE(fit_power_law(std::vector{2.0, 2.0, 2.0}, std::vector{1.0, 2.0, 3.0}));
    EXPECT_FALSE(fit_power_law(std::vector{1.0, 2.0, 3.0}, std::vector{1.0, 0.0, 3.0}));
    EXPECT_FALSE(fit_power_law(std::vector{1.0, 2.0, 3.0}, std::vector{1.0, std::nan(""), 3.0}));
    EXPECT_FALSE(fit_power_law(std::vector{-1.0, 2.0, 3.0}, std::vector{1.0, 2.0, 3.0}));
}

} // namespace
