#include "analysis/anova/comparisons.h"

#include "analysis/anova/adjustments.h"
#include "analysis/exact.h"
#include "analysis/numerics/distributions.h"
#include "analysis/numerics/dunnett.h"
#include "analysis/numerics/studentized_range.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace analysis::anova {

namespace {

// A difference over its standard error; nothing over nothing is undefined.
double ratio(double difference, double standard_error) {
    if (standard_error == 0)
        return difference == 0 ? undefined
                               : std::copysign(std::numeric_limits<double>::infinity(), difference);
    return difference / standard_error;
}

constexpr numerics::Tail certain{0, -std::numeric_limits<double>::infinity()};

// p-values of many pairs share most of their work, which few do not repay.
class RangeTails {
  public:
    explicit RangeTails(std::size_t groups) : groups_(static_cast<double>(groups)) {
        if (groups >= few_groups)
            shared_.emplace(groups_);
    }

    numerics::Tail operator()(double q, double df) {
        if (std::isnan(q) || !(df > 0))
            return {undefined, undefined};
        if (std::isinf(q))
            return certain;
        return shared_ ? shared_->upper_tail(q, df)
                       : numerics::studentized_range_upper_tail(q, groups_, df);
    }

  private:
    static constexpr std::size_t few_groups = 12; // 66 pairs: as fast either way when measured

    double groups_;
    std::optional<numerics::StudentizedRanges> shared_;
};

RangePair range_pair(std::size_t first,
                     std::size_t second,
                     double difference,
                     double standard_error,
                     double df,
                     RangeTails& tails) {
    RangePair pair;
    pair.first = first;
    pair.second = second;
    pair.difference = difference;
    pair.standard_error = standard_error;
    pair.df = df;
    pair.q = ratio(std::abs(difference), standard_error);
    const auto tail = tails(pair.q, df);
    pair.p = tail.p;
    pair.log10_p = tail.log10_p;
    return pair;
}

void decide(RangePair& pair, double q_critical, double level) {
    pair.lower = pair.difference - q_critical * pair.standard_error;
    pair.upper = pair.difference + q_critical * pair.standard_error;
    pair.significant = pair.p < level;
}

void adjust(std::vector<TPair>& pairs, double level) {
    std::vector<double> p;
    for (const auto& pair : pairs)
        p.push_back(pair.p);
    const auto by_bonferroni = bonferroni(p), by_holm = holm(p), by_hochberg = hochberg(p),
               by_bh = benjamini_hochberg(p);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        pairs[i].p_bonferroni = by_bonferroni[i];
        pairs[i].p_holm = by_holm[i];
        pairs[i].p_hochberg = by_hochberg[i];
        pairs[i].p_benjamini_hochberg = by_bh[i];
        pairs[i].significant_holm = by_holm[i] < level;
    }
}

void put_p(TPair& pair) {
    if (std::isnan(pair.t) || !(pair.df > 0))
        return;
    const auto tail = std::isinf(pair.t) ? certain : numerics::t_two_sided(pair.t, pair.df);
    pair.p = tail.p;
    pair.log10_p = tail.log10_p;
}

} // namespace

RangeTest tukey(std::span<const double> means,
                std::span<const std::int64_t> sizes,
                Variation error,
                double level) {
    const std::vector<double> real(sizes.begin(), sizes.end());
    return tukey(means, real, error, level);
}

RangeTest
tukey(std::span<const double> means, std::span<const double> sizes, Variation error, double level) {
    EXPECTS(means.size() == sizes.size() && means.size() >= 2);
    RangeTest test;
    test.level = level;
    test.groups = means.size();
    test.df = error.df;
    test.mean_square_error = error.df > 0 ? error.ms() : undefined;
    if (error.df > 0)
        test.q_critical = numerics::studentized_range_quantile(
            level, static_cast<double>(means.size()), error.df);
    RangeTails tails(means.size());
    for (std::size_t i = 0; i < means.size(); ++i)
        for (std::size_t j = i + 1; j < means.size(); ++j) {
            const double se = std::sqrt(test.mean_square_error / 2 * (1 / sizes[i] + 1 / sizes[j]));
            test.pairs.push_back(range_pair(i, j, means[i] - means[j], se, error.df, tails));
            decide(test.pairs.back(), test.q_critical, level);
        }
    if (std::all_of(sizes.begin(), sizes.end(), [&](auto size) { return size == sizes[0]; }))
        test.comparison_half_width =
            test.q_critical * std::sqrt(test.mean_square_error / sizes[0]) / 2;
    return test;
}

std::vector<RangePair> games_howell(const OneWay& groups, double level) {
    std::vector<RangePair> pairs;
    const auto k = groups.mean.size();
    RangeTails tails(k);
    for (std::size_t i = 0; i < k; ++i)
        for (std::size_t j = i + 1; j < k; ++j) {
            const double n_i = static_cast<double>(groups.n[i]);
            const double n_j = static_cast<double>(groups.n[j]);
            const double a = groups.variance[i] / n_i, b = groups.variance[j] / n_j;
            const double df = (a + b) * (a + b) / (a * a / (n_i - 1) + b * b / (n_j - 1));
            pairs.push_back(range_pair(i, j, groups.mean[i] - groups.mean[j],
                                       std::sqrt((a + b) / 2), df, tails));
            pairs.back().significant = pairs.back().p < level;
        }
    return pairs;
}

DunnettTest dunnett(std::span<const double> means,
                    std::span<const std::int64_t> sizes,
                    Variation error,
                    std::size_t control,
                    double level) {
    EXPECTS(means.size() == sizes.size() && means.size() >= 2 && control < means.size());
    DunnettTest test;
    test.control = control;
    test.df = error.df;
    const auto n_control = static_cast<double>(sizes[control]);
    std::vector<double> loading;
    for (std::size_t i = 0; i < means.size(); ++i)
        if (i != control) {
            const auto n = static_cast<double>(sizes[i]);
            loading.push_back(std::sqrt(n / (n + n_control)));
        }
    if (error.df > 0)
        test.t_critical = numerics::dunnett_quantile(level, loading, error.df);
    for (std::size_t i = 0; i < means.size(); ++i) {
        if (i == control)
            continue;
        const double mse = error.df > 0 ? error.ms() : undefined;
        const double se = std::sqrt(mse * (1 / static_cast<double>(sizes[i]) + 1 / n_control));
        DunnettPair pair;
        pair.level = i;
        pair.difference = means[i] - means[control];
        pair.t = ratio(pair.difference, se);
        if (error.df > 0)
            pair.p = numerics::dunnett_upper_tail(std::abs(pair.t), loading, error.df).p;
        pair.lower = pair.difference - test.t_critical * se;
        pair.upper = pair.difference + test.t_critical * se;
        pair.significant = pair.p < level;
        test.pairs.push_back(pair);
    }
    return test;
}

std::vector<TPair> pooled_t(const OneWay& groups, double level) {
    const std::vector<double> sizes(groups.n.begin(), groups.n.end());
    return pooled_t(groups.mean, sizes, groups.within, level);
}

std::vector<TPair> pooled_t(std::span<const double> means,
                            std::span<const double> sizes,
                            Variation error,
                            double level) {
    const double ms = error.df > 0 ? error.ms() : undefined;
    std::vector<Difference> differences;
    for (std::size_t i = 0; i < means.size(); ++i)
        for (std::size_t j = i + 1; j < means.size(); ++j)
            differences.push_back(
                {i, j, means[i] - means[j], std::sqrt(ms * (1 / sizes[i] + 1 / sizes[j]))});
    return t_of_differences(differences, error.df, level);
}

std::vector<TPair>
t_of_differences(std::span<const Difference> differences, double df, double level) {
    std::vector<TPair> pairs;
    for (const auto& difference : differences) {
        TPair pair;
        pair.first = difference.first;
        pair.second = difference.second;
        pair.difference = difference.value;
        pair.standard_error = difference.standard_error;
        pair.t = ratio(pair.difference, pair.standard_error);
        pair.df = df;
        put_p(pair);
        pairs.push_back(pair);
    }
    adjust(pairs, level);
    return pairs;
}

std::vector<TPair> paired_t(std::span<const std::int64_t> counts,
                            std::size_t groups,
                            std::int64_t divisor,
                            double level) {
    EXPECTS(groups >= 2 && counts.size() % groups == 0 && divisor > 0);
    const auto n = counts.size() / groups;
    std::vector<TPair> pairs;
    for (std::size_t i = 0; i < groups; ++i)
        for (std::size_t j = i + 1; j < groups; ++j) {
            Wide sum = 0, squares = 0;
            for (std::size_t o = 0; o < n; ++o) {
                const Wide d = counts[o * groups + i] - counts[o * groups + j];
                sum += d;
                squares += d * d;
            }
            const auto observers = static_cast<double>(n);
            const Wide spread = static_cast<Wide>(n) * squares - sum * sum;
            TPair pair;
            pair.first = i;
            pair.second = j;
            const double unit = observers * static_cast<double>(divisor);
            const double deviation = std::sqrt(static_cast<double>(spread) / (observers - 1));
            pair.difference = static_cast<double>(sum) / unit;
            pair.standard_error = deviation / unit;
            // mean / (sd / sqrt n), with everything over n and the divisor cancelled
            pair.t = ratio(static_cast<double>(sum), deviation);
            pair.df = observers - 1;
            put_p(pair);
            pairs.push_back(pair);
        }
    adjust(pairs, level);
    return pairs;
}

std::vector<TPair> paired_t(std::span<const long double> values, std::size_t groups, double level) {
    EXPECTS(groups >= 2 && !values.empty() && values.size() % groups == 0);
    const auto n = values.size() / groups;
    const auto subjects = static_cast<long double>(n);
    std::vector<Difference> differences;
    for (std::size_t i = 0; i < groups; ++i)
        for (std::size_t j = i + 1; j < groups; ++j) {
            long double mean = 0, squares = 0;
            for (std::size_t o = 0; o < n; ++o)
                mean += (values[o * groups + i] - values[o * groups + j]) / subjects;
            bool constant = true;
            for (std::size_t o = 0; o < n; ++o) {
                const long double d = values[o * groups + i] - values[o * groups + j];
                constant = constant && d == values[i] - values[j];
                squares += (d - mean) * (d - mean);
            }
            const long double variance = constant ? 0 : squares / (subjects - 1);
            differences.push_back({i, j, static_cast<double>(mean),
                                   static_cast<double>(std::sqrt(variance / subjects))});
        }
    return t_of_differences(differences, static_cast<double>(subjects - 1), level);
}

std::vector<std::pair<std::size_t, std::size_t>> differing(std::span<const RangePair> pairs) {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (const auto& pair : pairs)
        if (pair.significant)
            found.emplace_back(pair.first, pair.second);
    return found;
}

} // namespace analysis::anova
