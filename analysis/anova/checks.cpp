#include "analysis/anova/checks.h"

#include "analysis/numerics/distributions.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace analysis::anova {

namespace {

template <class Centre>
FTest of_distances(std::span<const std::vector<double>> groups, Centre centre) {
    std::vector<std::vector<double>> distances;
    for (const auto& group : groups) {
        const long double middle = centre(group);
        auto& out = distances.emplace_back();
        for (const double value : group)
            out.push_back(static_cast<double>(std::abs(value - middle)));
    }
    return one_way(distances).test;
}

} // namespace

FTest levene(std::span<const std::vector<double>> groups) {
    return of_distances(groups, [](const std::vector<double>& group) {
        long double sum = 0; // about the first value, so that a common offset costs nothing
        for (const double value : group)
            sum += static_cast<long double>(value) - group[0];
        return group[0] + sum / static_cast<long double>(group.size());
    });
}

FTest brown_forsythe(std::span<const std::vector<double>> groups) {
    return of_distances(groups, [](std::vector<double> group) {
        std::sort(group.begin(), group.end());
        const auto n = group.size();
        return (static_cast<long double>(group[(n - 1) / 2]) + group[n / 2]) / 2;
    });
}

FTest levene(std::span<const std::vector<std::int64_t>> groups) {
    std::vector<std::vector<std::int64_t>> distances(groups.begin(), groups.end());
    for (auto& group : distances) {
        const auto n = static_cast<std::int64_t>(group.size());
        std::int64_t sum = 0;
        for (const auto value : group)
            sum += value;
        for (auto& value : group)
            value = std::abs(n * value - sum); // n times the distance: F does not mind
    }
    return one_way_of_counts(distances, 1).test;
}

FTest brown_forsythe(std::span<const std::vector<std::int64_t>> groups) {
    std::vector<std::vector<std::int64_t>> distances(groups.begin(), groups.end());
    for (auto& group : distances) {
        auto sorted = group;
        std::sort(sorted.begin(), sorted.end());
        const auto n = sorted.size();
        const auto doubled_median = sorted[(n - 1) / 2] + sorted[n / 2];
        for (auto& value : group)
            value = std::abs(2 * value - doubled_median);
    }
    return one_way_of_counts(distances, 1).test;
}

FTest welch(const OneWay& groups) {
    FTest test;
    const auto k = static_cast<double>(groups.n.size());
    double weights = 0, weighted = 0;
    for (std::size_t i = 0; i < groups.n.size(); ++i) {
        if (!(groups.variance[i] > 0)) {
            test.outcome = Outcome::Undefined;
            test.reason = "a group does not vary, so its weight is infinite";
            return test;
        }
        const double w = static_cast<double>(groups.n[i]) / groups.variance[i];
        weights += w;
        weighted += w * (groups.mean[i] - groups.grand_mean);
    }
    const double centre = groups.grand_mean + weighted / weights;
    double between = 0, lambda = 0;
    for (std::size_t i = 0; i < groups.n.size(); ++i) {
        const auto n = static_cast<double>(groups.n[i]);
        const double w = n / groups.variance[i], distance = groups.mean[i] - centre;
        between += w * distance * distance / (k - 1);
        lambda += (1 - w / weights) * (1 - w / weights) / (n - 1);
    }
    test.outcome = Outcome::Computed;
    test.f = between / (1 + 2 * (k - 2) * lambda / (k * k - 1));
    test.df1 = k - 1;
    test.df2 = (k * k - 1) / (3 * lambda);
    const auto tail = numerics::f_upper_tail(test.f, test.df1, test.df2);
    test.p = tail.p;
    test.log10_p = tail.log10_p;
    return test;
}

} // namespace analysis::anova
