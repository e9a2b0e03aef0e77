// What a few bands make of the thickness of a sphere, d = 2 (-x)+ at a vertex with x = N.s, and of
// a jump.
//
// All functions here depend on x alone, so their coefficients are zonal, and the sphere's mean is
// the mean over x in -1..1.  The midpoint rule with 20,000 steps is exact to 1e-8 for the kink and
// 1e-4 for the jump; the tabulated numbers are rounded in their last digit, which sets the
// tolerances.
#include "renderer/harmonics/basis.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace {

using namespace renderer::harmonics;

constexpr int steps = 20000;

double position(int i) {
    return -1.0 + (i + 0.5) * 2.0 / steps;
}

std::vector<double> zonal_basis(int bands, double x) {
    std::vector<double> all(static_cast<std::size_t>(coefficient_count(bands)));
    evaluate(bands, {std::sqrt(1.0 - x * x), 0.0, x}, all);
    std::vector<double> zonal;
    for (int l = 0; l < bands; ++l)
        zonal.push_back(all[static_cast<std::size_t>(flat_index(l, 0))]);
    return zonal;
}

using Function = std::function<double(double x)>;
using Window = std::function<double(int l, int bands)>;

double plain(int, int) {
    return 1.0;
}

double hann(int l, int bands) {
    return (1.0 + std::cos(std::numbers::pi * l / bands)) / 2.0;
}

double lanczos(int l, int bands) {
    const double a = std::numbers::pi * l / bands;
    return l == 0 ? 1.0 : std::sin(a) / a;
}

/// The function's first bands, weighted by a window, at every position.
std::vector<double> reconstructed(const Function& f, int bands, const Window& window = plain) {
    std::vector<double> c(static_cast<std::size_t>(bands));
    for (int i = 0; i < steps; ++i) {
        const auto y = zonal_basis(bands, position(i));
        for (std::size_t l = 0; l < c.size(); ++l)
            c[l] += f(position(i)) * y[l] * 4.0 * std::numbers::pi / steps;
    }
    std::vector<double> values;
    for (int i = 0; i < steps; ++i) {
        const auto y = zonal_basis(bands, position(i));
        double value = 0.0;
        for (int l = 0; l < bands; ++l)
            value +=
                window(l, bands) * c[static_cast<std::size_t>(l)] * y[static_cast<std::size_t>(l)];
        values.push_back(value);
    }
    return values;
}

/// Root mean square of values minus f over the positions from..to.
double
rms(const std::vector<double>& values, const Function& f, double from = -1.0, double to = 1.0) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < steps; ++i)
        if (position(i) > from && position(i) < to) {
            sum += std::pow(values[static_cast<std::size_t>(i)] - f(position(i)), 2);
            ++count;
        }
    return std::sqrt(sum / count);
}

double largest_error(const std::vector<double>& values, const Function& f) {
    double largest = 0.0;
    for (int i = 0; i < steps; ++i)
        largest = std::max(largest, std::abs(values[static_cast<std::size_t>(i)] - f(position(i))));
    return largest;
}

std::vector<double> clamped(std::vector<double> values) {
    for (auto& value : values)
        value = std::max(value, 0.0);
    return values;
}

double sphere(double x) {
    return 2.0 * std::max(-x, 0.0);
}

TEST(Truncation, WindowsCostASphereThreeTimesTheError) {
    const auto with_lanczos = reconstructed(sphere, 5, lanczos);
    EXPECT_NEAR(rms(with_lanczos, sphere), 0.09799, 1e-5);
    EXPECT_NEAR(largest_error(with_lanczos, sphere), 0.2471, 1e-4);
    EXPECT_NEAR(std::ranges::min(with_lanczos), -0.0261, 1e-4);
    EXPECT_NEAR(with_lanczos.front(), 1.8647, 3e-4); // half a step from the pole, slope 1.5
    const auto with_hann = reconstructed(sphere, 5, hann);
    EXPECT_NEAR(rms(with_hann, sphere), 0.12986, 1e-5);
    EXPECT_NEAR(largest_error(with_hann, sphere), 0.2888, 1e-4);
    EXPECT_NEAR(std::ranges::min(with_hann), -0.0316, 1e-4);
    EXPECT_NEAR(with_hann.front(), 1.7957, 3e-4);
}

TEST(Truncation, WindowsTameAJump) {
    const Function step = [](double x) { return x > 0.0 ? 1.0 : 0.0; };
    EXPECT_NEAR(std::ranges::max(reconstructed(step, 5)) - 1.0, 0.114, 5e-4);
    EXPECT_NEAR(std::ranges::max(reconstructed(step, 5, lanczos)) - 1.0, 0.044, 5e-4);
    EXPECT_NEAR(std::ranges::max(reconstructed(step, 5, hann)) - 1.0, 0.039, 5e-4);
}

// The paper's claim that four coefficients do in front, in numbers: a tenth of the diameter is
// left.
TEST(Truncation, LeavesTheLitSideOfASphereItsTabulatedError) {
    const double lit[] = {0.2041, 0.0571, 0.0278};
    const double unlit[] = {0.2887, 0.0722, 0.0361};
    const int bands[] = {2, 3, 5};
    for (int k = 0; k < 3; ++k) {
        const auto thickness = clamped(reconstructed(sphere, bands[k]));
        EXPECT_NEAR(rms(thickness, sphere, 0.0, 1.0), lit[k], 1e-4) << bands[k];
        EXPECT_NEAR(rms(thickness, sphere, -1.0, 0.0), unlit[k], 1e-4) << bands[k];
    }
}

TEST(Truncation, OfThicknessBeatsThatOfTransmissionFromThreeBandsOn) {
    const Function transmission = [](double x) { return std::exp(-sphere(x)); };
    const double of_thickness[] = {0.157, 0.050, 0.026};
    const double of_itself[] = {0.112, 0.075, 0.035}; // projected instead, and clamped to 0..1
    const int bands[] = {2, 3, 5};
    for (int k = 0; k < 3; ++k) {
        auto values = clamped(reconstructed(sphere, bands[k]));
        for (auto& value : values)
            value = std::exp(-value);
        EXPECT_NEAR(rms(values, transmission), of_thickness[k], 6e-4) << bands[k];
        auto projected = clamped(reconstructed(transmission, bands[k]));
        for (auto& value : projected)
            value = std::min(value, 1.0);
        EXPECT_NEAR(rms(projected, transmission), of_itself[k], 6e-4) << bands[k];
    }
}

} // namespace
