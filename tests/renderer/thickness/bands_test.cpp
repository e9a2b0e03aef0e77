// The numbers of truncation, from closed forms: a field of one vertex at the pole of a body that is
// round about the pole's axis, so that only the orders m = 0 are there.
#include "renderer/geometry/body_thickness.h"
#include "renderer/harmonics/basis.h"
#include "renderer/thickness/bands.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace {

using namespace renderer::thickness;
using renderer::harmonics::coefficient_count;
using renderer::harmonics::flat_index;
using std::numbers::pi;

glm::dvec3 at_height(double z) {
    return {std::sqrt(std::max(0.0, 1 - z * z)), 0, z};
}

/// Projects d(z) by the midpoint rule in z: a kink costs 1/200000^2, a square root at its end
/// 1/200000^1.5 = 1e-8.
ThicknessField zonal_field(int bands, const std::function<double(double)>& d) {
    const int count = 200000;
    const double solid_angle = 4 * pi / count;
    std::vector<double> y(static_cast<std::size_t>(coefficient_count(bands))), c(y.size());
    ThicknessField field;
    field.bands = bands;
    field.energy = {0};
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2.0 * i + 1) / count, length = d(z);
        if (length == 0)
            continue;
        renderer::harmonics::evaluate(bands, at_height(z), y);
        for (int l = 0; l < bands; ++l)
            c[static_cast<std::size_t>(flat_index(l, 0))] +=
                solid_angle * length * y[static_cast<std::size_t>(flat_index(l, 0))];
        field.energy[0] += solid_angle * length * length;
    }
    field.coefficients.assign(c.begin(), c.end());
    return field;
}

double sphere_chord(double z) {
    return 2 * std::max(0.0, -z);
}

auto shell_chord(double inner_radius) {
    return [=](double z) {
        return renderer::geometry::shell_thickness(1, inner_radius, {0, 0, 1}, at_height(z)).sum;
    };
}

double zonal(const ThicknessField& field, int l) {
    return field.coefficients[static_cast<std::size_t>(flat_index(l, 0))];
}

struct Extremes {
    double error = 0, smallest = 0, opposite = 0;
};

Extremes extremes(const ThicknessField& field, int bands) {
    std::vector<double> y(field.coefficients.size());
    Extremes found;
    for (int i = 0; i <= 2000; ++i) {
        const double z = 1 - i / 1000.0;
        renderer::harmonics::evaluate(field.bands, at_height(z), y);
        const double d = reconstruct(field, 0, y, bands);
        found.error = std::max(found.error, std::abs(d - sphere_chord(z)));
        found.smallest = std::min(found.smallest, d);
        found.opposite = d; // ends at z = -1
    }
    return found;
}

// Coefficients are kept as floats: 1e-7 relative.
TEST(Bands, OfASphereAreThoseOfTheClampedCosine) {
    const auto field = zonal_field(11, sphere_chord);
    const std::vector<double> expected{1.7724539, -2.0466534, 0.9908318,  0, -0.2215567, 0,
                                       0.0998543, 0,          -0.0570939, 0, 0.0370162};
    for (int l = 0; l < 11; ++l)
        EXPECT_NEAR(zonal(field, l), expected[static_cast<std::size_t>(l)], 3e-7) << l;
    EXPECT_NEAR(field.energy[0], 8.3775804, 1e-6);
}

TEST(Bands, TruncationOnASphereIsAsTabulated) {
    const auto field = zonal_field(7, sphere_chord);

    struct Row {
        int bands;
        double kept, rms, error, smallest, opposite;
    };

    const std::vector<Row> table{
        {2, .8750, .28868, .5000, -.5000, 1.5000}, {3, .9922, .07217, .1875, -.0792, 2.1250},
        {4, .9922, .07217, .1875, -.0792, 2.1250}, {5, .9980, .03608, .1172, -.0625, 1.9375},
        {6, .9980, .03608, .1172, -.0625, 1.9375}, {7, .9992, .02255, .0855, -.0310, 2.0391}};
    for (const auto& row : table) {
        // half a unit of the last printed digit, and 1e-5 for floats under a square root
        EXPECT_NEAR(energy_kept(field, row.bands), row.kept, 6e-5) << row.bands;
        EXPECT_NEAR(truncation_rms(field, 0, row.bands), row.rms, 1.5e-5) << row.bands;
        const auto found = extremes(field, row.bands);
        EXPECT_NEAR(found.error, row.error, 6e-5) << row.bands;
        EXPECT_NEAR(found.smallest, row.smallest, 6e-5) << row.bands;
        EXPECT_NEAR(found.opposite, row.opposite, 6e-5) << row.bands;
    }
}

TEST(Bands, OfAShellAreAsTabulated) {
    const auto field = zonal_field(6, shell_chord(0.5));
    const std::vector<double> expected{1.616442, -1.790822, 0.695582,
                                       0.293092, -0.480250, 0.202076};
    for (int l = 0; l < 6; ++l)
        EXPECT_NEAR(zonal(field, l), expected[static_cast<std::size_t>(l)], 1.5e-6) << l;
    EXPECT_NEAR(field.energy[0], 6.694006, 2e-6);
}

TEST(Bands, HollowBodiesNeedMore) {
    struct Row {
        double inner_radius;
        std::vector<double> kept; // at 2, 3, 5, 8 and 10 bands
    };

    const std::vector<Row> table{{0.5, {.869, .942, .989, .996, .997}},
                                 {0.9, {.660, .673, .849, .946, .976}},
                                 {0.99, {.360, .451, .566, .718, .775}}};
    for (const auto& row : table) {
        const auto field = zonal_field(10, shell_chord(row.inner_radius));
        const std::vector<int> bands{2, 3, 5, 8, 10};
        for (std::size_t i = 0; i < bands.size(); ++i)
            EXPECT_NEAR(energy_kept(field, bands[i]), row.kept[i], 6e-4)
                << row.inner_radius << " with " << bands[i];
    }
}

TEST(Bands, ABodyWithoutThicknessLosesNothing) {
    const ThicknessField field{.bands = 1, .coefficients = {0}, .energy = {0}, .d_n = 0};
    EXPECT_EQ(truncation_rms(field, 0, 1), 0);
    EXPECT_EQ(energy_kept(field, 1), 1);
}

TEST(BandsDeathTest, RefuseBandsThatAreNotThere) {
    const ThicknessField field{.bands = 1, .coefficients = {0}, .energy = {0}, .d_n = 0};
    EXPECT_DEATH(truncation_rms(field, 0, 2), "bands");
    EXPECT_DEATH(truncation_rms(field, 1, 1), "energy.size");
}

} // namespace
