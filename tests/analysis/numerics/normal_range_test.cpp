#include "analysis/numerics/normal_range.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace analysis::numerics;

// Of two normals, the range is sqrt(2) times the size of one: P(range > w) = erfc(w / 2).
TEST(NormalRange, OfTwoIsThatOfTheirDifference) {
    NormalRange range(2, 1.0);
    for (const long double w : {0.01L, 0.3L, 1.0L, 2.5L, 6.0L, 15.0L, 29.0L, 31.0L, 60.0L}) {
        // The sums keep 15 digits of the tail, the logarithm as many of its own.
        const long double upper = std::log(std::erfc(w / 2));
        EXPECT_LE(std::abs(range.log_upper(w) - upper), 2e-14L * (1 + std::abs(upper))) << w;
        const long double lower = std::log(std::erf(w / 2));
        EXPECT_LE(std::abs(range.log_lower(w) - lower), 2e-14L * (1 + std::abs(lower))) << w;
    }
}

TEST(NormalRange, HasTwoTailsThatMakeOne) {
    for (const double k : {3.0, 7.0, 50.0}) {
        NormalRange range(k, 1.0);
        for (const long double w : {1.0L, 2.0L, 4.0L, 6.0L})
            EXPECT_LE(std::abs(std::exp(range.log_upper(w)) + std::exp(range.log_lower(w)) - 1),
                      2e-14L)
                << k << " " << w;
    }
}

// 20 terms leave the error of the sums themselves.
TEST(NormalRangePieces, AreTheSums) {
    for (const double k : {2.0, 5.0, 30.0}) {
        NormalRange range(k, 1.0);
        NormalRangePieces pieces(k);
        for (const long double w : {0.05L, 0.25L, 1.9L, 3.0L, 8.4L, 20.0L, 29.99L, 30.0L, 40.0L}) {
            const auto sum = range.log_upper(w);
            EXPECT_LE(std::abs(pieces.log_upper(w) - sum), 2e-14L * (1 + std::abs(sum)))
                << k << " " << w;
        }
    }
}

} // namespace
