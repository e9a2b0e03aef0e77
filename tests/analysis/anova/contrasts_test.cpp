#include "analysis/anova/contrasts.h"
#include "analysis/anova/residuals.h"

#include <cmath>
#include <numeric>

namespace {

using namespace analysis::anova;

// Orthonormal contrasts of all sets together keep the length of what they were given.
TEST(Contrasts, OfAllSetsTogetherKeepTheSumOfSquares) {
    const std::vector<std::size_t> sizes{2, 3, 4};
    std::vector<long double> values(24);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = std::sin(static_cast<long double>(7 * i + 1));
    long double given = 0, found = 0;
    std::size_t scores = 0;
    for (const auto value : values)
        given += value * value;
    for (const unsigned set : {0U, 2U, 4U, 6U}) {
        const auto contrast = contrast_scores(sizes, values, set);
        scores += contrast.size();
        for (const auto score : contrast)
            found += score * score;
    }
    EXPECT_EQ(scores, values.size());
    EXPECT_NEAR(static_cast<double>(found), static_cast<double>(given), 1e-16 * 24);
}

TEST(Contrasts, OfEqualValuesAreExactlyZero) {
    const std::vector<std::size_t> sizes{2, 5};
    const std::vector<long double> values(10, 0.1L);
    for (const auto score : contrast_scores(sizes, values, 2U))
        EXPECT_EQ(score, 0.0L);
}

// Row and column sums of residuals are zero; scores are fitted plus residual.
TEST(WithinResiduals, AddUpToNothingAlongBothWays) {
    const std::vector<std::int64_t> counts{5, 3, 1, 6, 2, 1, 3, 4, 2, 0, 9, 0};
    const auto result = within_residuals(counts, 3, 2);
    ASSERT_EQ(result.residual.size(), counts.size());
    for (std::size_t o = 0; o < 4; ++o)
        EXPECT_NEAR(result.residual[3 * o] + result.residual[3 * o + 1] +
                        result.residual[3 * o + 2],
                    0, 1e-15);
    for (std::size_t level = 0; level < 3; ++level) {
        double sum = 0;
        for (std::size_t o = 0; o < 4; ++o)
            sum += result.residual[3 * o + level];
        EXPECT_NEAR(sum, 0, 1e-15);
    }
    for (std::size_t i = 0; i < counts.size(); ++i)
        EXPECT_NEAR(result.fitted[i] + result.residual[i], static_cast<double>(counts[i]) / 2,
                    1e-15);
}

} // namespace
