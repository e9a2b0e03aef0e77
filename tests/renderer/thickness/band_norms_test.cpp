#include "renderer/geometry/bodies.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/directions.h"
#include "renderer/thickness/band_norms.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace renderer::thickness;

TEST(BandNorms, HaveTheTabulatedFactors) {
    EXPECT_NEAR(dropped_factor(2, 5), 1.2927, 5e-5);
    EXPECT_NEAR(dropped_factor(3, 5), 1.1284, 5e-5);
    EXPECT_NEAR(dropped_factor(1, 5), 1.3820, 5e-5);
    EXPECT_EQ(dropped_factor(5, 5), 0);
}

/// Largest of |dropped thickness| over its bound, at all vertices and `count` directions; ends the
/// test where it is above 1.
double tightest(const ThicknessField& field, int count) {
    const auto norms = band_norms(field);
    EXPECT_EQ(norms.norm.size(), field.energy.size() * static_cast<std::size_t>(field.bands));
    std::vector<double> y(static_cast<std::size_t>(field.bands * field.bands));
    double largest = 0;
    for (const auto& s : renderer::harmonics::fibonacci_directions(count, 6).directions) {
        renderer::harmonics::evaluate(field.bands, s, y);
        for (std::size_t v = 0; v < field.energy.size(); ++v)
            for (int n = 1; n < field.bands; ++n) {
                const double dropped =
                    std::abs(reconstruct(field, v, y, field.bands) - reconstruct(field, v, y, n));
                // the sums themselves are right to 1e-15 of their terms
                EXPECT_LE(dropped, dropped_bound(norms, v, n) + 1e-14);
                if (dropped > 1e-6)
                    largest = std::max(largest, dropped / dropped_bound(norms, v, n));
            }
    }
    return largest;
}

TEST(BandNorms, AreNeverExceededOnATracedBody) {
    const auto field =
        compute_thickness_field(renderer::geometry::torus(1, 0.4, 20, 12), {.directions = 256});
    ASSERT_TRUE(field) << field.error();
    EXPECT_GT(tightest(*field, 500), 0.5); // no idle bound
}

// c along y(s) itself: there Cauchy's inequality is an equation, with nothing to spare.
TEST(BandNorms, AreReachedByTheWorstOfAll) {
    ThicknessField field;
    field.bands = 5;
    std::vector<double> y(25);
    for (const auto& s : renderer::harmonics::fibonacci_directions(200, 6).directions) {
        renderer::harmonics::evaluate(5, s, y);
        for (const double value : y)
            field.coefficients.push_back(static_cast<float>(value));
    }
    field.energy.resize(200);
    EXPECT_NEAR(tightest(field, 200), 1, 1e-6); // floats
}

TEST(BandNorms, AreNeverExceededByVerticesOfVeryDifferentThickness) {
    std::mt19937_64 random(4);
    std::normal_distribution<float> normal;
    ThicknessField field;
    field.bands = 5;
    field.energy.resize(300);
    for (std::size_t v = 0; v < field.energy.size(); ++v) {
        const float size = std::exp(3 * normal(random));
        for (int i = 0; i < 25; ++i)
            field.coefficients.push_back(size * normal(random));
    }
    EXPECT_GT(tightest(field, 200), 0.3);
}

TEST(BandNorms, OfNothingBoundNothing) {
    ThicknessField field;
    field.bands = 2;
    field.coefficients.assign(8, 0);
    field.energy.resize(2);
    EXPECT_EQ(dropped_bound(band_norms(field), 1, 1), 0);
}

TEST(BandNormsDeathTest, RefuseWhatIsNotThere) {
    ThicknessField field;
    field.bands = 2;
    field.coefficients.assign(8, 0);
    field.energy.resize(2);
    EXPECT_DEATH(dropped_bound(band_norms(field), 2, 1), "norm.size");
    EXPECT_DEATH(dropped_bound(band_norms(field), 0, 0), "bands");
}

} // namespace
