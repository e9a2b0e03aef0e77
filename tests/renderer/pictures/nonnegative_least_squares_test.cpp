#include "renderer/pictures/nonnegative_least_squares.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using Solver = renderer::pictures::NonnegativeLeastSquares;
using Weights = Solver::Weights;

struct Equation {
    Weights a;
    double y;
};

Solver solver_of(const std::vector<Equation>& equations) {
    Solver solver;
    for (const auto& [a, y] : equations)
        solver.add_equation(a, y);
    return solver;
}

double dot(const Weights& a, const Weights& x) {
    return a[0] * x[0] + a[1] * x[1] + a[2] * x[2] + a[3] * x[3];
}

double squared_error(const std::vector<Equation>& equations, const Weights& x) {
    double sum = 0;
    for (const auto& [a, y] : equations)
        sum += std::pow(dot(a, x) - y, 2);
    return sum;
}

/// Uniform over [0, 1), the same with every standard library.
double share(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

std::vector<Equation> random_equations(std::size_t count, std::mt19937_64& random) {
    std::vector<Equation> equations(count);
    for (auto& [a, y] : equations) {
        for (auto& each : a)
            each = share(random);
        y = share(random) - 0.3;
    }
    return equations;
}

TEST(NonnegativeLeastSquares, GivesBackTheWeightsAnExactTargetWasMadeWith) {
    std::mt19937_64 random(1);
    auto equations = random_equations(200, random);
    for (const Weights& truth :
         {Weights{0.1, 0.5, 0.04, 0.3}, Weights{0, 0.5, 0, 0.3}, Weights{}}) {
        for (auto& [a, y] : equations)
            y = dot(a, truth);
        const auto solution = solver_of(equations).solve();
        for (std::size_t j = 0; j < truth.size(); ++j)
            EXPECT_NEAR(solution.x[j], truth[j], 1e-13);
        EXPECT_NEAR(solution.squared_error, 0, 1e-24);
    }
}

// The conditions of Karush, Kuhn and Tucker, necessary and sufficient for a convex problem: with g
// the gradient, x_j > 0 wants g_j = 0, and x_j = 0 wants g_j >= 0.
TEST(NonnegativeLeastSquares, IsOptimalForAnyTarget) {
    std::mt19937_64 random(2);
    int bound = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const auto equations = random_equations(12, random);
        const auto solution = solver_of(equations).solve();
        Weights gradient{};
        for (const auto& [a, y] : equations)
            for (std::size_t j = 0; j < a.size(); ++j)
                gradient[j] += 2 * a[j] * (dot(a, solution.x) - y);
        for (std::size_t j = 0; j < gradient.size(); ++j) {
            ASSERT_GE(solution.x[j], 0);
            ASSERT_GE(gradient[j], -1e-12);
            if (solution.x[j] > 0)
                ASSERT_NEAR(gradient[j], 0, 1e-12);
            else
                ++bound;
        }
        ASSERT_NEAR(solution.squared_error, squared_error(equations, solution.x), 1e-12);
    }
    EXPECT_GT(bound, 100); // the bounds were met often enough to matter
}

TEST(NonnegativeLeastSquares, NamesColumnsThatAreAbsent) {
    std::mt19937_64 random(3);
    auto equations = random_equations(50, random);
    for (auto& [a, y] : equations) {
        a[3] = 0;
        y = 2 * a[1];
    }
    const auto solution = solver_of(equations).solve();
    EXPECT_EQ(solution.absent, (std::array{false, false, false, true}));
    EXPECT_EQ(solution.x[3], 0);
    EXPECT_NEAR(solution.x[1], 2, 1e-13);
}

// Two columns a relative 1e-7 apart: normal equations would see them equal (1e-14 of their
// squares).
TEST(NonnegativeLeastSquares, KeepsNearlyDependentColumnsApart) {
    std::mt19937_64 random(4);
    auto equations = random_equations(400, random);
    const Weights truth{0.2, 0.3, 0.1, 0.4};
    for (auto& [a, y] : equations) {
        a[2] = a[1] + 1e-7 * (2 * share(random) - 1);
        y = dot(a, truth);
    }
    const auto solution = solver_of(equations).solve();
    // Condition number about 1e7, times the rounding of 400 rotations.
    for (std::size_t j = 0; j < truth.size(); ++j)
        EXPECT_NEAR(solution.x[j], truth[j], 1e-6) << j;
}

TEST(NonnegativeLeastSquares, GivesEqualColumnsToOneOfThem) {
    std::mt19937_64 random(5);
    auto equations = random_equations(100, random);
    for (auto& [a, y] : equations) {
        a[2] = a[1];
        y = 0.5 * a[1] + 0.25 * a[0];
    }
    const auto solution = solver_of(equations).solve();
    EXPECT_NEAR(solution.x[0], 0.25, 1e-12);
    EXPECT_NEAR(solution.x[1] + solution.x[2], 0.5, 1e-12);
    EXPECT_EQ(std::min(solution.x[1], solution.x[2]), 0);
    EXPECT_NEAR(solution.squared_error, 0, 1e-20);
}

TEST(NonnegativeLeastSquares, WithoutEquationsIsZero) {
    const auto solution = Solver().solve();
    EXPECT_EQ(solution.x, Weights{});
    EXPECT_EQ(solution.squared_error, 0);
    EXPECT_EQ(solution.absent, (std::array{true, true, true, true}));
}

TEST(NonnegativeLeastSquares, OfATargetBelowZeroIsZero) {
    const auto solution = solver_of({{{1, 0, 0, 0}, -1}, {{0, 1, 1, 0}, -2}}).solve();
    EXPECT_EQ(solution.x, Weights{});
    EXPECT_NEAR(solution.squared_error, 5, 1e-14);
}

} // namespace
