#include "analysis/anova/adjustments.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace analysis::anova {

namespace {

// Indices of the p that are numbers, smallest first; equal ones in their order.
std::vector<std::size_t> ascending(std::span<const double> p) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (!std::isnan(p[i]))
            order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return p[a] < p[b]; });
    return order;
}

// Running minimum from the largest p down; `factor(r)` multiplies the r-th smallest.
template <class Factor>
std::vector<double> step_up(std::span<const double> p, Factor factor) {
    std::vector<double> adjusted(p.begin(), p.end());
    const auto order = ascending(p);
    double run = 1;
    for (auto r = order.size(); r-- > 0;) {
        run = std::min(run, factor(r, order.size()) * p[order[r]]);
        adjusted[order[r]] = run;
    }
    return adjusted;
}

} // namespace

std::vector<double> bonferroni(std::span<const double> p) {
    std::vector<double> adjusted(p.begin(), p.end());
    const auto m = static_cast<double>(ascending(p).size());
    for (auto& value : adjusted)
        if (!std::isnan(value))
            value = std::min(1.0, m * value);
    return adjusted;
}

std::vector<double> holm(std::span<const double> p) {
    std::vector<double> adjusted(p.begin(), p.end());
    const auto order = ascending(p);
    double run = 0;
    for (std::size_t r = 0; r < order.size(); ++r) {
        run = std::max(run, std::min(1.0, static_cast<double>(order.size() - r) * p[order[r]]));
        adjusted[order[r]] = run;
    }
    return adjusted;
}

std::vector<double> hochberg(std::span<const double> p) {
    return step_up(p, [](std::size_t r, std::size_t m) { return static_cast<double>(m - r); });
}

std::vector<double> benjamini_hochberg(std::span<const double> p) {
    return step_up(p, [](std::size_t r, std::size_t m) {
        return static_cast<double>(m) / static_cast<double>(r + 1);
    });
}

} // namespace analysis::anova
