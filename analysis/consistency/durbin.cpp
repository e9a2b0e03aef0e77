#include "analysis/consistency/durbin.h"

#include "analysis/numerics/distributions.h"
#include "protocols/contract.h"

#include <algorithm>
#include <limits>

namespace analysis::consistency {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

DurbinTest untestable(std::string reason) {
    DurbinTest test;
    test.chi_squared = test.df = test.p = test.f = test.df1 = test.df2 = test.p_f = undefined;
    test.reason = std::move(reason);
    return test;
}

bool all_equal(const std::vector<int>& counts) {
    return std::all_of(counts.begin(), counts.end(), [&](int c) { return c == counts[0]; });
}

std::string unbalanced(std::span<const IncompleteBlock> blocks, std::size_t t) {
    std::vector<int> appearances(t), together(t * t);
    for (const auto& block : blocks) {
        if (block.conditions.size() != blocks[0].conditions.size())
            return "observers ranked different numbers of conditions";
        for (const auto i : block.conditions) {
            ++appearances[i];
            for (const auto j : block.conditions)
                ++together[i * t + j];
        }
    }
    std::vector<int> pairs;
    for (std::size_t i = 0; i < t; ++i)
        for (std::size_t j = i + 1; j < t; ++j)
            pairs.push_back(together[i * t + j]);
    if (!all_equal(appearances))
        return "conditions were ranked by different numbers of observers";
    return all_equal(pairs) ? "" : "pairs of conditions were ranked together unequally often";
}

double mid_rank(const std::vector<double>& values, double value) {
    double rank = 0.5;
    for (const double other : values)
        rank += other < value ? 1 : other == value ? 0.5 : 0;
    return rank;
}

} // namespace

DurbinTest durbin(std::span<const IncompleteBlock> blocks, std::size_t conditions) {
    EXPECTS(!blocks.empty() && conditions >= 2);
    for (const auto& block : blocks) {
        EXPECTS(block.conditions.size() == block.values.size() && block.values.size() >= 2);
        for (const auto condition : block.conditions)
            EXPECTS(condition < conditions);
    }
    if (const auto why = unbalanced(blocks, conditions); !why.empty())
        return untestable(why);
    DurbinTest test;
    test.rank_sums.assign(conditions, 0);
    double squares = 0; // ranks are multiples of 1/2: these sums are exact
    for (const auto& block : blocks)
        for (std::size_t i = 0; i < block.values.size(); ++i) {
            const double rank = mid_rank(block.values, block.values[i]);
            test.rank_sums[block.conditions[i]] += rank;
            squares += rank * rank;
        }
    const auto b = static_cast<double>(blocks.size()), t = static_cast<double>(conditions);
    const auto k = static_cast<double>(blocks[0].values.size());
    const double expected = b * k / t * (k + 1) / 2; // of a rank sum
    double spread = 0;
    for (const double sum : test.rank_sums)
        spread += (sum - expected) * (sum - expected);
    const double untied = squares - b * k * (k + 1) * (k + 1) / 4;
    if (untied == 0)
        return untestable("0/0: every observer's values are all tied");
    test.df = test.df1 = t - 1;
    test.df2 = b * k - b - t + 1;
    test.chi_squared = (t - 1) * spread / untied;
    test.p = numerics::chi_squared_upper_tail(test.chi_squared, test.df).p;
    const double left = b * (k - 1) - test.chi_squared;
    test.f = test.p_f = undefined;
    if (left > 0 && test.df2 > 0) {
        test.f = test.chi_squared / test.df1 / (left / test.df2);
        test.p_f = numerics::f_upper_tail(test.f, test.df1, test.df2).p;
    } else {
        test.reason = "all observers rank alike: F has nothing to be compared with";
    }
    return test;
}

} // namespace analysis::consistency
