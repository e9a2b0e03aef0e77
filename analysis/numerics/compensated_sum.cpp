// Neumaier 1974: what an addition rounds away is kept in a second sum.
#include "analysis/numerics/compensated_sum.h"

#include <cmath>

namespace analysis::numerics {

double compensated_sum(std::span<const double> values) {
    double sum = 0.0;
    double lost = 0.0;
    for (const double value : values) {
        const double next = sum + value;
        lost += std::abs(sum) >= std::abs(value) ? (sum - next) + value : (value - next) + sum;
        sum = next;
    }
    return sum + lost;
}

} // namespace analysis::numerics
