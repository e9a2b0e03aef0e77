#include "analysis/scaling/cholesky.h"

#include <cmath>

namespace {

using analysis::scaling::Cholesky;

TEST(Cholesky, SolvesAndInvertsASmallSystem) {
    const std::vector<double> matrix{4, 2, 0, 2, 5, 3, 0, 3, 10};
    Cholesky cholesky;
    ASSERT_TRUE(cholesky.factor(matrix, 3));
    std::vector<double> b{8, 21, 36}; // the matrix times (1, 2, 3)
    cholesky.solve(b);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(b[i], static_cast<double>(i + 1), 1e-14);
    EXPECT_NEAR(cholesky.log_determinant(), std::log(124.0), 1e-14);
    const auto inverse = cholesky.inverse();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k)
                sum += matrix[i * 3 + k] * inverse[k * 3 + j];
            EXPECT_NEAR(sum, i == j ? 1 : 0, 1e-14);
        }
}

TEST(Cholesky, RefusesWhatIsNotPositiveDefinite) {
    Cholesky cholesky;
    EXPECT_FALSE(cholesky.factor(std::vector<double>{1, 2, 2, 1}, 2));
    EXPECT_FALSE(cholesky.factor(std::vector<double>{std::nan("")}, 1));
}

} // namespace
