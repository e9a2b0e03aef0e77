// Which groups differ: all pairs of means with simultaneous error rates.
// [Tukey1953], [Kramer1956], [GamesHowell1976], [Dunnett1955], [Holm1979], [Hochberg1988],
// [BenjaminiHochberg1995]
#pragma once

#include "analysis/anova/f_test.h"
#include "analysis/anova/one_way.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace analysis::anova {

/// One pair by the studentized range.  Groups by index, `first` < `second`.
struct RangePair {
    std::size_t first = 0;
    std::size_t second = 0;
    double difference = undefined;     ///< mean of first minus mean of second
    double standard_error = undefined; ///< as q uses it: of the difference, over sqrt 2
    double df = undefined;
    double q = undefined;
    double lower = undefined; ///< simultaneous interval of the difference
    double upper = undefined;
    double p = undefined;
    double log10_p = undefined; ///< speaks where p is below a double
    bool significant = false;   ///< at the level asked for
};

struct RangeTest {
    double level = 0.05;
    double q_critical = undefined;
    std::size_t groups = 0;
    double df = undefined;
    double mean_square_error = undefined;
    std::vector<RangePair> pairs;
    /// Half-width of comparison intervals: two are disjoint exactly when the pair differs (equal
    /// group sizes); NaN otherwise.
    double comparison_half_width = undefined;
};

/// Tukey's test, with Kramer's standard errors when sizes differ.  Sizes may be those of groups
/// whose means would be known as well.
RangeTest tukey(std::span<const double> means,
                std::span<const double> sizes,
                Variation error,
                double level = 0.05);
RangeTest tukey(std::span<const double> means,
                std::span<const std::int64_t> sizes,
                Variation error,
                double level = 0.05);

/// Each pair by its own variances and Welch's df; not simultaneous intervals.
std::vector<RangePair> games_howell(const OneWay& groups, double level = 0.05);

/// One level against the control.
struct DunnettPair {
    std::size_t level = 0;
    double difference = undefined; ///< mean of the level minus mean of the control
    double t = undefined;
    double p = undefined;     ///< of the largest of them
    double lower = undefined; ///< simultaneous interval of the difference
    double upper = undefined;
    bool significant = false;
};

struct DunnettTest {
    std::size_t control = 0;
    double df = undefined;
    double t_critical = undefined;
    std::vector<DunnettPair> pairs; ///< every level but the control
};

/// Every group against one, two-sided.  [Dunnett1955]
DunnettTest dunnett(std::span<const double> means,
                    std::span<const std::int64_t> sizes,
                    Variation error,
                    std::size_t control,
                    double level = 0.05);

/// One pair by t, with p adjusted for the number of pairs.
struct TPair {
    std::size_t first = 0;
    std::size_t second = 0;
    double difference = undefined;
    double standard_error = undefined; ///< of the difference
    double t = undefined;
    double df = undefined;
    double p = undefined;
    double log10_p = undefined;
    double p_bonferroni = undefined;
    double p_holm = undefined;
    double p_hochberg = undefined;
    double p_benjamini_hochberg = undefined;
    bool significant_holm = false;
};

/// Two-sided t with the pooled variance of all groups.
std::vector<TPair> pooled_t(const OneWay& groups, double level = 0.05);
std::vector<TPair> pooled_t(std::span<const double> means,
                            std::span<const double> sizes,
                            Variation error,
                            double level = 0.05);

/// An estimated difference of two levels.
struct Difference {
    std::size_t first = 0;
    std::size_t second = 0;
    double value = 0;
    double standard_error = 0;
};

/// Two-sided t of differences that all have `df` degrees of freedom.
std::vector<TPair>
t_of_differences(std::span<const Difference> differences, double df, double level = 0.05);

/// Two-sided paired t over observers; `counts` is row-major observers x groups, `divisor` of them
/// make one unit of score.  Exact up to the last division.
std::vector<TPair> paired_t(std::span<const std::int64_t> counts,
                            std::size_t groups,
                            std::int64_t divisor,
                            double level = 0.05);

/// Two-sided paired t of real values, row-major subjects x groups.
std::vector<TPair>
paired_t(std::span<const long double> values, std::size_t groups, double level = 0.05);

/// The pairs that differ at their level.
std::vector<std::pair<std::size_t, std::size_t>> differing(std::span<const RangePair> pairs);

} // namespace analysis::anova
