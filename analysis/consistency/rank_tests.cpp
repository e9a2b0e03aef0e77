#include "analysis/consistency/rank_tests.h"

#include "analysis/exact.h"
#include "analysis/numerics/distributions.h"
#include "analysis/numerics/studentized_range.h"
#include "protocols/contract.h"

#include <cmath>
#include <limits>

namespace analysis::consistency {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

// Adds twice the mid-ranks of one block; returns the sum of ties^3 - ties.
std::int64_t add_ranks(std::span<const std::int64_t> block, std::vector<std::int64_t>& doubled) {
    std::int64_t ties = 0;
    for (std::size_t i = 0; i < block.size(); ++i) {
        std::int64_t below = 0, equal = 0;
        for (const auto other : block) {
            below += other < block[i] ? 1 : 0;
            equal += other == block[i] ? 1 : 0;
        }
        doubled[i] += 2 * below + equal + 1;
        ties += equal * equal - 1; // each of `equal` members adds its share of equal^3 - equal
    }
    return ties;
}

} // namespace

RankTest friedman(std::span<const std::int64_t> scores, std::size_t conditions) {
    EXPECTS(conditions >= 2 && !scores.empty() && scores.size() % conditions == 0);
    const auto k = static_cast<std::int64_t>(conditions);
    const auto b = static_cast<std::int64_t>(scores.size() / conditions);
    std::vector<std::int64_t> doubled(conditions);
    std::int64_t ties = 0;
    for (std::size_t block = 0; block < static_cast<std::size_t>(b); ++block)
        ties += add_ranks(scores.subspan(block * conditions, conditions), doubled);
    RankTest result;
    result.blocks = static_cast<std::size_t>(b);
    result.conditions = conditions;
    Wide spread = 0; // 4 times the squares of rank sums about their mean
    for (const auto sum : doubled) {
        result.rank_sums.push_back(static_cast<double>(sum) / 2);
        const Wide distance = sum - b * (k + 1);
        spread += distance * distance;
    }
    const Wide untied = static_cast<Wide>(b) * k * (k * k - 1) - ties;
    result.df = static_cast<double>(k - 1);
    if (untied == 0) {
        result.chi_squared = result.p = result.kendall_w = result.f = result.p_f = undefined;
        result.reason = "0/0: every observer's scores are all tied";
        return result;
    }
    result.chi_squared = static_cast<double>(3 * spread * (k - 1)) / static_cast<double>(untied);
    result.kendall_w = static_cast<double>(3 * spread) / static_cast<double>(untied * b);
    result.p = numerics::chi_squared_upper_tail(result.chi_squared, result.df).p;
    const Wide disagreement = untied * b - 3 * spread;
    if (disagreement == 0 || b < 2) {
        result.f = result.p_f = undefined;
        result.reason = "all observers rank alike: F has nothing to be compared with";
        return result;
    }
    result.f = static_cast<double>(3 * spread * (b - 1)) / static_cast<double>(disagreement);
    result.p_f =
        numerics::f_upper_tail(result.f, result.df, static_cast<double>((b - 1) * (k - 1))).p;
    return result;
}

Nemenyi nemenyi(const RankTest& ranks, double level) {
    const auto b = static_cast<double>(ranks.blocks), k = static_cast<double>(ranks.conditions);
    const double se = std::sqrt(k * (k + 1) / (12 * b));
    const double infinite = std::numeric_limits<double>::infinity();
    Nemenyi result;
    numerics::StudentizedRanges ranges(k);
    result.critical_difference = numerics::studentized_range_quantile(level, k, infinite) * se;
    for (std::size_t i = 0; i < ranks.conditions; ++i)
        for (std::size_t j = i + 1; j < ranks.conditions; ++j) {
            const double difference = (ranks.rank_sums[i] - ranks.rank_sums[j]) / b;
            const double q = std::abs(difference) / se;
            result.pairs.push_back({i, j, difference, q, ranges.upper_tail(q, infinite).p});
        }
    return result;
}

} // namespace analysis::consistency
