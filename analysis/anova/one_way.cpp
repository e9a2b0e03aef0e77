#include "analysis/anova/one_way.h"

#include "analysis/exact.h"
#include "analysis/numerics/compensated_sum.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>

namespace analysis::anova {

namespace {

void read_off(OneWay& result) {
    result.test = f_test(result.between, result.within);
    const double total = result.between.ss + result.within.ss;
    const double error = result.within.ms();
    result.residual_sd = std::sqrt(error);
    if (total > 0 && result.within.df > 0) {
        result.eta_squared = result.between.ss / total;
        result.epsilon_squared = (result.between.ss - result.between.df * error) / total;
        result.omega_squared = (result.between.ss - result.between.df * error) / (total + error);
    }
}

double mean_of(std::span<const double> values, double shift) {
    std::vector<double> shifted(values.begin(), values.end());
    for (auto& value : shifted)
        value -= shift;
    return numerics::compensated_sum(shifted) / static_cast<double>(values.size());
}

// Squares about the mean, less what the mean's own rounding adds.
double squares_about(std::span<const double> values, double shift, double mean) {
    std::vector<double> residuals, squares;
    for (const auto value : values) {
        residuals.push_back(value - shift - mean);
        squares.push_back(residuals.back() * residuals.back());
    }
    const double left = numerics::compensated_sum(residuals);
    return std::max(0.0, numerics::compensated_sum(squares) -
                             left * left / static_cast<double>(values.size()));
}

bool constant(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [&](double v) { return v == values[0]; });
}

} // namespace

OneWay one_way(std::span<const std::vector<double>> groups) {
    EXPECTS(groups.size() >= 2);
    OneWay result;
    const double shift = groups[0].empty() ? 0 : groups[0][0];
    std::vector<double> all, within, means;
    for (const auto& group : groups) {
        EXPECTS(!group.empty());
        all.insert(all.end(), group.begin(), group.end());
        const auto n = static_cast<double>(group.size());
        means.push_back(constant(group) ? group[0] - shift : mean_of(group, shift));
        within.push_back(constant(group) ? 0 : squares_about(group, shift, means.back()));
        result.n.push_back(static_cast<std::int64_t>(group.size()));
        result.mean.push_back(shift + means.back());
        result.variance.push_back(group.size() > 1 ? within.back() / (n - 1) : undefined);
    }
    const double grand = mean_of(all, shift);
    std::vector<double> between;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const double distance = means[g] - grand;
        between.push_back(static_cast<double>(groups[g].size()) * distance * distance);
    }
    const auto k = static_cast<double>(groups.size());
    const auto n = static_cast<double>(all.size());
    result.grand_mean = shift + grand;
    result.between = {constant(means) ? 0 : numerics::compensated_sum(between), k - 1};
    result.within = {numerics::compensated_sum(within), n - k};
    read_off(result);
    return result;
}

OneWay one_way_of_counts(std::span<const std::vector<std::int64_t>> groups, std::int64_t divisor) {
    EXPECTS(groups.size() >= 2 && divisor > 0);
    const auto k = static_cast<std::int64_t>(groups.size());
    const auto n = static_cast<std::int64_t>(groups[0].size());
    EXPECTS(n > 0);
    OneWay result;
    Wide total = 0, squared_totals = 0, within = 0;
    const auto unit = static_cast<double>(divisor);
    for (const auto& group : groups) {
        EXPECTS(static_cast<std::int64_t>(group.size()) == n);
        Wide sum = 0, squares = 0;
        for (const auto value : group) {
            sum += value;
            squares += static_cast<Wide>(value) * value;
        }
        const Wide spread = n * squares - sum * sum; // n times the squares about the mean
        total += sum;
        squared_totals += sum * sum;
        within += spread;
        result.n.push_back(n);
        result.mean.push_back(static_cast<double>(sum) / static_cast<double>(n * divisor));
        result.variance.push_back(n > 1 ? static_cast<double>(spread) /
                                              (static_cast<double>(n * (n - 1)) * unit * unit)
                                        : undefined);
    }
    const double scale = unit * unit;
    result.grand_mean = static_cast<double>(total) / static_cast<double>(k * n * divisor);
    result.between = {static_cast<double>(k * squared_totals - total * total) /
                          (static_cast<double>(k * n) * scale),
                      static_cast<double>(k - 1)};
    result.within = {static_cast<double>(within) / (static_cast<double>(n) * scale),
                     static_cast<double>(k * n - k)};
    read_off(result);
    return result;
}

} // namespace analysis::anova
