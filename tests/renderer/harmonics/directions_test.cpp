#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/directions.h"

#include <glm/glm.hpp>

#include <cmath>
#include <numbers>
#include <numeric>

namespace {

using namespace renderer::harmonics;

double total_weight(const DirectionSet& set) {
    return std::accumulate(set.weights.begin(), set.weights.end(), 0.0);
}

TEST(Directions, WeightsCoverTheSphere) {
    EXPECT_NEAR(total_weight(fibonacci_directions(1024, 1)), 4 * std::numbers::pi, 1e-12);
    for (const int degree : {0, 1, 8, 31, 100})
        EXPECT_NEAR(total_weight(gauss_directions(degree)), 4 * std::numbers::pi, 1e-12) << degree;
}

TEST(Directions, AreUnitVectors) {
    auto all = fibonacci_directions(1000, 5).directions;
    const auto gauss = gauss_directions(20).directions;
    all.insert(all.end(), gauss.begin(), gauss.end());
    for (const auto& s : all)
        EXPECT_NEAR(glm::length(s), 1, 1e-15);
}

TEST(Directions, GaussRulesHaveTheirTabulatedSizes) {
    EXPECT_EQ(gauss_directions(8).directions.size(), 45u);
    EXPECT_EQ(gauss_directions(9).directions.size(), 50u);
    EXPECT_EQ(gauss_directions(31).directions.size(), 512u);
}

// Products of two functions of degree < n have degree 2n - 2: their integrals are the identity.
TEST(Directions, GramMatrixUnderGaussIsTheIdentity) {
    const int bands = 10;
    const std::size_t n = coefficient_count(bands);
    const auto set = gauss_directions(2 * bands - 2);
    std::vector<double> gram(n * n), y(n);
    for (std::size_t j = 0; j < set.directions.size(); ++j) {
        evaluate(bands, set.directions[j], y);
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b < n; ++b)
                gram[a * n + b] += set.weights[j] * y[a] * y[b];
    }
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < n; ++b)
            EXPECT_NEAR(gram[a * n + b], a == b ? 1 : 0, 1e-13) << a << ' ' << b;
}

TEST(Directions, SeedsTurnTheWholeSet) {
    const auto a = fibonacci_directions(64, 1), again = fibonacci_directions(64, 1),
               b = fibonacci_directions(64, 2);
    EXPECT_EQ(a.directions, again.directions);
    EXPECT_GT(glm::distance(a.directions[0], b.directions[0]), 0.01);
    // one rotation for all: angles inside the set stay
    EXPECT_NEAR(glm::dot(a.directions[3], a.directions[40]),
                glm::dot(b.directions[3], b.directions[40]), 1e-14);
    EXPECT_GT(glm::determinant(glm::dmat3(a.directions[0], a.directions[1], a.directions[2])) *
                  glm::determinant(glm::dmat3(b.directions[0], b.directions[1], b.directions[2])),
              0); // a rotation, not a mirror
}

// Nearest neighbours of N even points lie about sqrt(4 pi / N) apart; a clump or a hole would show.
TEST(Directions, FibonacciPointsKeepTheirDistance) {
    const int count = 1000;
    const auto set = fibonacci_directions(count, 9);
    const double even = std::sqrt(4 * std::numbers::pi / count);
    for (std::size_t i = 0; i < set.directions.size(); ++i) {
        double nearest = 2;
        for (std::size_t j = 0; j < set.directions.size(); ++j)
            if (i != j)
                nearest = std::min(nearest, glm::distance(set.directions[i], set.directions[j]));
        EXPECT_GT(nearest, 0.6 * even);
        EXPECT_LT(nearest, 1.2 * even);
    }
}

} // namespace
