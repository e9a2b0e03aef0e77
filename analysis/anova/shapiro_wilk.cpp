#include "analysis/anova/shapiro_wilk.h"

#include "analysis/numerics/compensated_sum.h"
#include "analysis/numerics/distributions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace analysis::anova {

namespace {

// Coefficients of [Royston1995], lowest power first.
double polynomial(std::initializer_list<double> coefficients, double x) {
    double value = 0;
    for (auto c = std::rbegin(coefficients); c != std::rend(coefficients); ++c)
        value = value * x + *c;
    return value;
}

// Weights a_1 .. a_h of the ordered differences x(n+1-i) - x(i).
std::vector<double> weights(std::size_t n) {
    const auto h = n / 2;
    if (n == 3)
        return {std::sqrt(0.5)};
    std::vector<double> m(h), a(h);
    double squares = 0;
    for (std::size_t i = 0; i < h; ++i) {
        m[i] = numerics::normal_quantile((static_cast<double>(i) + 0.625) /
                                         (static_cast<double>(n) + 0.25));
        squares += 2 * m[i] * m[i];
    }
    const double r = 1 / std::sqrt(static_cast<double>(n)), root = std::sqrt(squares);
    a[0] = polynomial({0, 0.221157, -0.147981, -2.07119, 4.434685, -2.706056}, r) - m[0] / root;
    double phi = 0;
    std::size_t given = 1;
    if (n > 5) {
        a[1] =
            polynomial({0, 0.042981, -0.293762, -1.752461, 5.682633, -3.582633}, r) - m[1] / root;
        phi = std::sqrt((squares - 2 * m[0] * m[0] - 2 * m[1] * m[1]) /
                        (1 - 2 * a[0] * a[0] - 2 * a[1] * a[1]));
        given = 2;
    } else {
        phi = std::sqrt((squares - 2 * m[0] * m[0]) / (1 - 2 * a[0] * a[0]));
    }
    for (std::size_t i = given; i < h; ++i)
        a[i] = -m[i] / phi;
    return a;
}

double p_value(double one_minus_w, std::size_t count) {
    const auto n = static_cast<double>(count);
    if (count == 3) {
        const double limit = std::asin(std::sqrt(0.75));
        return std::max(0.0,
                        6 / std::numbers::pi * (std::asin(std::sqrt(1 - one_minus_w)) - limit));
    }
    double y = std::log(one_minus_w), mean = 0, log_sd = 0;
    if (count <= 11) {
        const double limit = -2.273 + 0.459 * n;
        if (y >= limit)
            return 1e-99; // "less than": the approximation ends here
        y = -std::log(limit - y);
        mean = polynomial({0.544, -0.39978, 0.025054, -0.0006714}, n);
        log_sd = polynomial({1.3822, -0.77857, 0.062767, -0.0020322}, n);
    } else {
        const double l = std::log(n);
        mean = polynomial({-1.5861, -0.31082, -0.083751, 0.0038915}, l);
        log_sd = polynomial({-0.4803, -0.082676, 0.0030302}, l);
    }
    return numerics::normal_upper_tail((y - mean) / std::exp(log_sd)).p;
}

} // namespace

ShapiroWilk shapiro_wilk(std::span<const double> values) {
    constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
    const auto n = values.size();
    if (n < 3)
        return {undefined, undefined, "needs at least 3 values"};
    std::vector<double> x(values.begin(), values.end());
    std::sort(x.begin(), x.end());
    if (!(x.front() < x.back()))
        return {undefined, undefined, "all values are equal"};
    // Centred before anything: an offset of 1e9 would cost eight digits.
    for (const double shift = x[n / 2]; auto& value : x)
        value -= shift;
    const double mean = numerics::compensated_sum(x) / static_cast<double>(n);
    std::vector<double> squares;
    for (const auto value : x)
        squares.push_back((value - mean) * (value - mean));
    const auto a = weights(n);
    double b = 0, a_squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        b += a[i] * (x[n - 1 - i] - x[i]);
        a_squares += 2 * a[i] * a[i];
    }
    const double product = a_squares * numerics::compensated_sum(squares);
    const double q = std::sqrt(product);
    const double one_minus_w = std::max(0.0, (q - b) * (q + b) / product);
    return {1 - one_minus_w, p_value(one_minus_w, n),
            n > 5000 ? "more than 5000 values: p is outside its tested range" : ""};
}

} // namespace analysis::anova
