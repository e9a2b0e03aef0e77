#include "analysis/numerics/compensated_sum.h"

#include <vector>

namespace {

using analysis::numerics::compensated_sum;

TEST(CompensatedSum, KeepsWhatAPlainSumLoses) {
    EXPECT_EQ(compensated_sum(std::vector{1.0, 1e100, 1.0, -1e100}), 2.0); // a plain sum gives 0
}

TEST(CompensatedSum, OfNothingIsZero) {
    EXPECT_EQ(compensated_sum({}), 0.0);
}

} // namespace
