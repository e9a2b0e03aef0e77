#include "analysis/consistency/equality.h"

#include "analysis/consistency/exact_laws.h"
#include "analysis/numerics/distributions.h"
#include "analysis/numerics/studentized_range.h"
#include "protocols/contract.h"

#include <cmath>
#include <limits>

namespace analysis::consistency {

EqualityTest david_equality(const VoteMatrix& matrix) {
    const auto t = static_cast<std::int64_t>(matrix.conditions());
    const auto m = matrix.complete();
    EXPECTS(t >= 2 && m > 0);
    Wide squares = 0; // of half votes: 4 times those of votes
    for (std::size_t i = 0; i < matrix.conditions(); ++i)
        squares += static_cast<Wide>(matrix.half_votes(i)) * matrix.half_votes(i);
    const Wide spread = squares - static_cast<Wide>(m) * m * (t - 1) * (t - 1) * t;
    EqualityTest test{t, m, 0, static_cast<double>(t - 1), 0};
    test.d = static_cast<double>(spread) / (static_cast<double>(m) * static_cast<double>(t));
    test.p = numerics::chi_squared_upper_tail(test.d, test.df).p;
    return test;
}

VoteRangeTest range_test(const VoteMatrix& matrix) {
    VoteRangeTest test;
    test.conditions = static_cast<std::int64_t>(matrix.conditions());
    test.votes_per_pair = matrix.complete();
    EXPECTS(test.conditions >= 2 && test.votes_per_pair > 0);
    const auto t = static_cast<double>(test.conditions);
    const double spread = std::sqrt(static_cast<double>(test.votes_per_pair) * t) / 2;
    const double infinite = std::numeric_limits<double>::infinity();
    test.w_005 = numerics::studentized_range_quantile(0.05, t, infinite);
    test.w_001 = numerics::studentized_range_quantile(0.01, t, infinite);
    test.real_range_005 = test.w_005 * spread + 0.25;
    test.real_range_001 = test.w_001 * spread + 0.25;
    test.critical_range_005 = std::ceil(test.real_range_005);
    test.critical_range_001 = std::ceil(test.real_range_001);
    const auto level_of = [&](double range) {
        return range_p_exact(static_cast<std::int64_t>(range), test.votes_per_pair, test.conditions)
            .value_or(std::numeric_limits<double>::quiet_NaN());
    };
    test.exact_level_005 = level_of(test.critical_range_005);
    test.exact_level_001 = level_of(test.critical_range_001);
    for (std::size_t i = 0; i < matrix.conditions(); ++i)
        for (std::size_t j = i + 1; j < matrix.conditions(); ++j) {
            const double d = static_cast<double>(matrix.half_votes(i) - matrix.half_votes(j)) / 2;
            test.pairs.push_back({i, j, d, std::abs(d) >= test.critical_range_005,
                                  std::abs(d) >= test.critical_range_001});
        }
    return test;
}

} // namespace analysis::consistency
