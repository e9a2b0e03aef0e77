#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/directions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace renderer::harmonics;

std::vector<double> basis_at(int bands, glm::dvec3 direction) {
    std::vector<double> y(static_cast<std::size_t>(coefficient_count(bands)));
    evaluate(bands, direction, y);
    return y;
}

double sum_of_band(int l, const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (int m = -l; m <= l; ++m) {
        const auto i = static_cast<std::size_t>(flat_index(l, m));
        sum += a[i] * b[i];
    }
    return sum;
}

// The convention: sqrt(3/4pi) (y, z, x) in band 1, sqrt(15/4pi) xy first and (x^2 - y^2)/2 last in
// band 2, no Condon-Shortley sign anywhere.
TEST(Basis, SignsAndOrderAreOurs) {
    const glm::dvec3 s = glm::normalize(glm::dvec3(0.3, -0.5, 0.7));
    const auto y = basis_at(3, s);
    const double first = 0.28209479177387814, second = 0.48860251190291992,
                 third = 1.0925484305920792;
    const std::vector<double> expected{first,
                                       second * s.y,
                                       second * s.z,
                                       second * s.x,
                                       third * s.x * s.y,
                                       third * s.y * s.z,
                                       third / std::sqrt(12.0) * (3 * s.z * s.z - 1),
                                       third * s.x * s.z,
                                       third / 2 * (s.x * s.x - s.y * s.y)};
    ASSERT_EQ(y.size(), expected.size());
    for (std::size_t i = 0; i < y.size(); ++i)
        EXPECT_NEAR(y[i], expected[i], 4e-16) << i; // a few roundings of numbers below 1
}

// Twenty bands go by recurrences, ten by polynomials.
TEST(Basis, AgreesWithItsDefinition) {
    for (const int bands : {10, 20}) {
        std::vector<double> slow(static_cast<std::size_t>(coefficient_count(bands)));
        for (const auto& s : fibonacci_directions(50, 7).directions) {
            const auto fast = basis_at(bands, s);
            evaluate_by_definition(bands, s, slow);
            for (std::size_t i = 0; i < slow.size(); ++i) // the twin's sqrt(1 - z^2) is what errs
                EXPECT_NEAR(fast[i], slow[i], 1e-11) << i;
        }
    }
}

// Each is right to 1.2e-14 where it is best, and recurrences to twice that.
TEST(Basis, AgreesWithItsRecurrences) {
    for (int bands = 1; bands <= 12; ++bands) {
        std::vector<double> other(static_cast<std::size_t>(coefficient_count(bands)));
        for (const auto& s : fibonacci_directions(200, 11).directions) {
            const auto y = basis_at(bands, s);
            evaluate_by_recurrence(bands, s, other);
            for (std::size_t i = 0; i < y.size(); ++i)
                EXPECT_NEAR(y[i], other[i], 3.6e-14) << bands << ' ' << i;
        }
    }
}

// sum_m y_lm(a) y_lm(b) = (2l+1)/4pi P_l(a.b): every product of functions of one band at once.
// The sum has 2l+1 terms of size up to (2l+1)/4pi, each right to a few 1e-16 times l.
TEST(Basis, ObeysTheAdditionTheorem) {
    const int bands = 101;
    auto directions = fibonacci_directions(8, 3).directions;
    directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}});
    for (const auto& a : directions)
        for (const auto& b : directions) {
            const auto at_a = basis_at(bands, a), at_b = basis_at(bands, b);
            // rounding may leave a.a above 1, where P_l grows like 1 + l(l+1)/2 (a.a - 1)
            const double cosine = std::clamp(glm::dot(a, b), -1.0, 1.0);
            double before = 0, legendre = 1; // P_{l-1}, P_l
            for (int l = 0; l < bands; ++l) {
                // relative to the size of one term's worth, (2l+1)/4pi
                const double scale = (2 * l + 1) / (4 * std::numbers::pi);
                EXPECT_NEAR(sum_of_band(l, at_a, at_b) / scale, legendre, 1e-12) << "band " << l;
                const double next = ((2 * l + 1) * cosine * legendre - l * before) / (l + 1);
                before = legendre;
                legendre = next;
            }
        }
}

TEST(Basis, SquaresOfFiveBandsAddUpToTwentyFiveOverTheSphere) {
    for (const auto& s : fibonacci_directions(20, 1).directions) {
        double sum = 0;
        for (const double y : basis_at(5, s))
            sum += y * y;
        EXPECT_NEAR(sum, 25 / (4 * std::numbers::pi), 1e-14); // 25 squares of about 0.08
    }
}

// What reaches the graphics card: values rounded to float, 441 of them.
TEST(Basis, OfTwentyOneBandsInFloatObeysTheAdditionTheorem) {
    const int bands = 21;
    const auto directions = fibonacci_directions(12, 5).directions;
    for (const auto& a : directions)
        for (const auto& b : directions) {
            const auto at_a = basis_at(bands, a), at_b = basis_at(bands, b);
            float sum = 0;
            for (std::size_t i = 400; i < 441; ++i) // band 20
                sum += static_cast<float>(at_a[i]) * static_cast<float>(at_b[i]);
            const double scale = 41 / (4 * std::numbers::pi);
            EXPECT_NEAR(sum / scale, std::legendre(20, std::clamp(glm::dot(a, b), -1.0, 1.0)),
                        1e-5);
        }
}

TEST(Basis, OrdersVanishExactlyAtThePoles) {
    for (const int bands : {5, 10, 40})
        for (const double z : {1.0, -1.0})
            for (const double zero : {0.0, -0.0}) {
                const auto y = basis_at(bands, {zero, -zero, z});
                for (int l = 0; l < bands; ++l)
                    for (int m = -l; m <= l; ++m)
                        if (m != 0) {
                            EXPECT_EQ(y[static_cast<std::size_t>(flat_index(l, m))], 0)
                                << l << ' ' << m;
                        }
            }
}

TEST(Basis, IsFiniteBesideThePole) {
    const double denormal = 1e-310;
    for (const int bands : {10, 20})
        for (const double value : basis_at(bands, {denormal, -denormal, 1}))
            EXPECT_TRUE(std::isfinite(value));
}

TEST(BasisDeathTest, RefusesADirectionThatIsNotUnit) {
    std::vector<double> y(4);
    EXPECT_DEATH(evaluate(2, {0, 0, 1.01}, y), "is_unit");
    EXPECT_DEATH(evaluate(3, {0, 0, 1}, y), "out.size");
}

} // namespace
