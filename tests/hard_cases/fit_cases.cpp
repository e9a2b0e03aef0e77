// Fits whose equations hardly tell their unknowns apart.
#include "analysis/scaling/bradley_terry.h"
#include "analysis/scaling/thurstone.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/directions.h"
#include "renderer/harmonics/projection.h"
#include "renderer/pictures/nonnegative_least_squares.h"
#include "tests/hard_cases/hard_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hard_cases {

namespace {

const std::string area = "near-singular fits";

Case few_directions() {
    using namespace renderer::harmonics;
    Worst worst(area, "25 coefficients from 27 directions; of the largest",
                "the series that was sampled", 13);
    const auto set = fibonacci_directions(27, 1);
    std::vector<double> truth(25), samples, y(25);
    for (std::size_t i = 0; i < truth.size(); ++i)
        truth[i] = std::cos(3.0 * static_cast<double>(i));
    for (const auto& s : set.directions) {
        evaluate(5, s, y);
        double sum = 0;
        for (std::size_t i = 0; i < y.size(); ++i)
            sum += truth[i] * y[i];
        samples.push_back(sum);
    }
    const auto found = project(projection_rows(5, set), samples);
    for (std::size_t i = 0; i < truth.size(); ++i)
        worst.see(found[i], truth[i], 1);
    return worst.result();
}

/// Columns that agree but for a millionth: their normal equations have a condition of 1e12.
Case nearly_equal_columns() {
    Worst worst(area, "weights of two columns that agree to 1e-6", "the weights that made the data",
                8);
    const renderer::pictures::NonnegativeLeastSquares::Weights truth{0.25, 0.5, 0.75, 0.125};
    renderer::pictures::NonnegativeLeastSquares fit;
    for (int i = 0; i < 100; ++i) {
        const double x = i / 100.0, same = 1 + x * x;
        const renderer::pictures::NonnegativeLeastSquares::Weights a{
            same, same + 1e-6 * std::cos(7 * x), x, std::sin(5 * x)};
        double y = 0;
        for (std::size_t j = 0; j < a.size(); ++j)
            y += truth[j] * a[j];
        fit.add_equation(a, y);
    }
    const auto found = fit.solve().x;
    for (std::size_t j = 0; j < truth.size(); ++j)
        worst.see(found[j], truth[j]);
    return worst.result();
}

/// Votes of a chain: each condition against the next only, so that every step stands for itself.
std::array<std::int64_t, 25> chain(std::array<std::int64_t, 4> lost) {
    std::array<std::int64_t, 25> wins{};
    for (std::size_t i = 0; i < lost.size(); ++i) {
        wins[i * 5 + i + 1] = 1'000'000 - lost[i];
        wins[(i + 1) * 5 + i] = lost[i];
    }
    return wins;
}

constexpr std::array<std::int64_t, 4> lost{1, 999'999, 10, 500'000};

Case nearly_separated_logit() {
    Worst worst(area, "Bradley-Terry, all but one of a million votes for one side",
                "log-odds of a chain", 11);
    const auto wins = chain(lost);
    const auto fit = analysis::scaling::fit_bradley_terry({5, wins});
    for (std::size_t i = 0; i < lost.size(); ++i) {
        const auto p = static_cast<long double>(lost[i]);
        worst.see(fit.theta[i] - fit.theta[i + 1], std::log((1'000'000 - p) / p), 1);
    }
    return worst.result();
}

/// z with upper tail p, by Newton's iteration on the error function.
long double normal_quantile_of_upper(long double p) {
    using std::numbers::pi_v, std::numbers::sqrt2_v;
    long double z = 0;
    for (int step = 0; step < 200; ++step) {
        const long double tail = std::erfc(z / sqrt2_v<long double>) / 2;
        const long double density = std::exp(-z * z / 2) / std::sqrt(2 * pi_v<long double>);
        z += std::clamp((tail - p) / density, -0.5L, 0.5L);
    }
    return z;
}

Case nearly_separated_probit() {
    Worst worst(area, "Thurstone, the same votes", "normal quantiles in 64 bits", 11);
    const auto wins = chain(lost);
    const auto fit = analysis::scaling::fit_thurstone({5, wins});
    for (std::size_t i = 0; i < lost.size(); ++i)
        worst.see(fit.theta[i] - fit.theta[i + 1],
                  normal_quantile_of_upper(static_cast<long double>(lost[i]) / 1'000'000), 1);
    return worst.result();
}

} // namespace

void add_fits(std::vector<Case>& cases) {
    cases.push_back(few_directions());
    cases.push_back(nearly_equal_columns());
    cases.push_back(nearly_separated_logit());
    cases.push_back(nearly_separated_probit());
}

} // namespace hard_cases
