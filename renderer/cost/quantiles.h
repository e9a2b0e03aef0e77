// Times of many rounds in a few numbers.
#pragma once

#include <span>
#include <vector>

namespace renderer::cost {

/// The value below which a share `q` of the values lies, between neighbours by proportion.
/// Errors: EXPECTS values, and q in 0..1.
double quantile(std::vector<double> values, double q);

/// Median and quartiles: half of the values lie between `lower` and `upper`.
struct Spread {
    double lower = 0, median = 0, upper = 0;
    bool operator==(const Spread&) const = default;
};

/// Errors: EXPECTS values.
Spread spread_of(const std::vector<double>& values);

/// values[i] / base[i], of as many rounds as both have: what the machine was like in a round meets
/// both.
std::vector<double> ratios(std::span<const double> values, std::span<const double> base);

} // namespace renderer::cost
