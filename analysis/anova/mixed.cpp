// Along each orthonormal contrast between levels the scores are a plain one-way layout of groups,
// and the sums of squares of the table are sums over the contrasts.
#include "analysis/anova/mixed.h"

#include "analysis/exact.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace analysis::anova {

namespace {

struct GroupSums {
    std::vector<Wide> sums;
    std::vector<std::int64_t> sizes;
    Wide squares = 0;
};

GroupSums group_sums(const std::vector<Wide>& values, std::span<const int> groups, std::size_t g) {
    GroupSums result{std::vector<Wide>(g), std::vector<std::int64_t>(g), 0};
    for (std::size_t o = 0; o < values.size(); ++o) {
        result.sums[static_cast<std::size_t>(groups[o])] += values[o];
        ++result.sizes[static_cast<std::size_t>(groups[o])];
        result.squares += values[o] * values[o];
    }
    return result;
}

struct Parts {
    double weighted = 0, unweighted = 0, between = 0, within = 0;
};

// Sums of squares of one contrast about zero, between groups and within them.  Numerators are
// integers, so what does not vary is exactly zero.
Parts parts(const GroupSums& data, double scale) {
    Parts result;
    Wide total = 0;
    std::int64_t observers = 0, common = 1;
    for (std::size_t h = 0; h < data.sums.size(); ++h) {
        total += data.sums[h];
        observers += data.sizes[h];
        common *= data.sizes[h];
    }
    Wide by_group = 0, means = 0; // sum of S^2/n and of S/n, both times `common`
    double weights = 0;
    for (std::size_t h = 0; h < data.sums.size(); ++h) {
        by_group += data.sums[h] * data.sums[h] * (common / data.sizes[h]);
        means += data.sums[h] * (common / data.sizes[h]);
        weights += 1 / static_cast<double>(data.sizes[h]);
    }
    const auto n = static_cast<double>(observers), c = static_cast<double>(common);
    const auto sum = static_cast<double>(total), mean_sum = static_cast<double>(means) / c;
    result.weighted = sum * sum / n / scale;
    result.unweighted = mean_sum * mean_sum / weights / scale;
    result.between =
        static_cast<double>(by_group * observers - total * total * common) / (n * c) / scale;
    result.within = static_cast<double>(data.squares * common - by_group) / c / scale;
    return result;
}

// Helmert's contrast r with integer weights; its squared length is r (r + 1).
std::vector<Wide>
contrast(std::span<const std::int64_t> counts, std::size_t levels, std::size_t r) {
    std::vector<Wide> values;
    for (std::size_t at = 0; at < counts.size(); at += levels) {
        Wide value = -static_cast<Wide>(r) * counts[at + r];
        for (std::size_t i = 0; i < r; ++i)
            value += counts[at + i];
        values.push_back(value);
    }
    return values;
}

} // namespace

MixedAnalysis mixed_of_counts(std::span<const std::int64_t> counts,
                              std::span<const int> groups,
                              std::size_t levels,
                              std::int64_t divisor) {
    EXPECTS(levels >= 2 && counts.size() == groups.size() * levels && divisor > 0);
    const auto g = static_cast<std::size_t>(*std::max_element(groups.begin(), groups.end())) + 1;
    EXPECTS(g >= 2 && groups.size() > g);
    const double unit = static_cast<double>(divisor) * static_cast<double>(divisor);
    const auto observers = static_cast<double>(groups.size()), between = static_cast<double>(g);
    const auto p = static_cast<double>(levels - 1);
    std::vector<Wide> totals(groups.size());
    for (std::size_t i = 0; i < counts.size(); ++i)
        totals[i / levels] += counts[i];
    const auto subject = parts(group_sums(totals, groups, g), unit * static_cast<double>(levels));
    MixedAnalysis result;
    result.group = {subject.between, between - 1};
    result.group_error = {subject.within, observers - between};
    result.method_unweighted.df = result.method_weighted.df = p;
    result.group_x_method.df = p * (between - 1);
    result.within_error.df = p * (observers - between);
    std::vector<double> scores(groups.size() * (levels - 1));
    for (std::size_t r = 1; r < levels; ++r) {
        const auto values = contrast(counts, levels, r);
        const auto length = static_cast<double>(r * (r + 1));
        const auto part = parts(group_sums(values, groups, g), unit * length);
        result.method_weighted.ss += part.weighted;
        result.method_unweighted.ss += part.unweighted;
        result.group_x_method.ss += part.between;
        result.within_error.ss += part.within;
        for (std::size_t o = 0; o < values.size(); ++o)
            scores[o * (levels - 1) + r - 1] = static_cast<double>(values[o]) / std::sqrt(length);
    }
    result.group_test = f_test(result.group, result.group_error);
    result.method_unweighted_test = f_test(result.method_unweighted, result.within_error);
    result.method_weighted_test = f_test(result.method_weighted, result.within_error);
    result.group_x_method_test = f_test(result.group_x_method, result.within_error);
    result.sphericity = sphericity(scores, groups, levels - 1, levels, result.group_x_method_test);
    return result;
}

} // namespace analysis::anova
