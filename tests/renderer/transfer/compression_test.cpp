#include "renderer/geometry/bodies.h"
#include "renderer/transfer/compression.h"
#include "renderer/transfer/transfer_field.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace renderer::transfer;

/// Signals near three planes of two directions each in twelve dimensions.
std::vector<float> three_planes(std::size_t count, float noise) {
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    std::vector<std::vector<float>> planes(3, std::vector<float>(36));
    for (auto& plane : planes)
        for (float& x : plane)
            x = normal(random);
    std::vector<float> signals;
    for (std::size_t v = 0; v < count; ++v) {
        const auto& plane = planes[v % 3];
        const float a = normal(random), b = normal(random);
        for (std::size_t i = 0; i < 12; ++i)
            signals.push_back(20 * plane[i] + a * plane[12 + i] + b * plane[24 + i] +
                              noise * normal(random));
    }
    return signals;
}

/// Transfer vectors of a ring: 720 signals of 75 floats.
std::vector<float> ring() {
    static const auto field =
        compute_transfer_field(renderer::geometry::torus(5, 2, 36, 20),
                               {{0.1, 0.2, 0.4}, {1, 1, 1}, 1.3}, 1, {.directions = 256});
    EXPECT_TRUE(field);
    return field->transfer;
}

double recomputed_error(const std::vector<float>& signals, const CompressedSignals& compressed) {
    std::vector<float> out(compressed.dimension);
    double sum = 0;
    for (std::size_t v = 0; v < signals.size() / out.size(); ++v) {
        decompress(compressed, v, out);
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double off =
                static_cast<double>(signals[v * out.size() + i]) - static_cast<double>(out[i]);
            sum += off * off;
        }
    }
    return sum;
}

double sum_of_squares(const std::vector<float>& signals) {
    double sum = 0;
    for (const float s : signals)
        sum += static_cast<double>(s) * static_cast<double>(s);
    return sum;
}

TEST(Compression, ReportsTheErrorThatCanBeRecomputed) {
    const auto signals = ring();
    const auto compressed = compress(signals, 75, {.clusters = 8, .vectors = 4});
    const double error = recomputed_error(signals, compressed);
    EXPECT_GT(error, 0);
    EXPECT_NEAR(compressed.squared_error / error, 1, 1e-9);
    EXPECT_NEAR(compressed.relative_error, std::sqrt(error / sum_of_squares(signals)), 1e-9);
    // and the fit knew it from eigenvalues alone; what is stored is rounded to float
    EXPECT_NEAR(compressed.history.back() / error, 1, 1e-2);
}

TEST(Compression, ErrorNeverGrowsAndStandsStillInTheEnd) {
    const auto signals = ring();
    const auto compressed = compress(signals, 75, {.clusters = 12, .vectors = 3});
    ASSERT_GE(compressed.history.size(), 2u);
    for (std::size_t k = 1; k < compressed.history.size(); ++k)
        EXPECT_LE(compressed.history[k], compressed.history[k - 1]) << k;
    EXPECT_LT(compressed.history.back(), 0.9 * compressed.history.front());
    EXPECT_TRUE(compressed.converged);
}

TEST(Compression, AllDirectionsAreExact) {
    const auto signals = ring();
    const auto compressed = compress(signals, 75, {.clusters = 4, .vectors = 75});
    EXPECT_LE(compressed.relative_error, 1e-6); // float's rounding
}

TEST(Compression, MoreVectorsAndMoreClustersHelp) {
    const auto signals = ring();
    const double few = compress(signals, 75, {.clusters = 4, .vectors = 2}).relative_error;
    EXPECT_LT(compress(signals, 75, {.clusters = 4, .vectors = 6}).relative_error, 0.5 * few);
    EXPECT_LT(compress(signals, 75, {.clusters = 32, .vectors = 2}).relative_error, 0.7 * few);
}

TEST(Compression, FindsPlanesThatAreThere) {
    const auto signals = three_planes(600, 0);
    const auto compressed = compress(signals, 12, {.clusters = 3, .vectors = 2});
    EXPECT_LE(compressed.relative_error, 1e-6);
    for (std::size_t v = 3; v < 600; ++v)
        EXPECT_EQ(compressed.cluster_of[v], compressed.cluster_of[v % 3]) << v;
}

TEST(Compression, DirectionsAreOrthonormal) {
    const auto compressed = compress(ring(), 75, {.clusters = 5, .vectors = 4});
    for (std::size_t k = 0; k < 5; ++k)
        for (std::size_t a = 1; a <= 4; ++a)
            for (std::size_t b = 1; b <= 4; ++b) {
                double dot = 0;
                for (std::size_t i = 0; i < 75; ++i)
                    dot += static_cast<double>(compressed.representatives[(k * 5 + a) * 75 + i]) *
                           static_cast<double>(compressed.representatives[(k * 5 + b) * 75 + i]);
                EXPECT_NEAR(dot, a == b ? 1 : 0, 1e-5);
            }
}

TEST(Compression, DoesNotDependOnTheNumberOfThreads) {
    const auto signals = ring();
    const auto run = [&](int threads) {
        CompressedSignals compressed;
        tbb::task_arena arena(threads);
        arena.execute([&] { compressed = compress(signals, 75, {.clusters = 16, .vectors = 4}); });
        return compressed;
    };
    const auto one = run(1), four = run(4);
    EXPECT_EQ(one.representatives, four.representatives);
    EXPECT_EQ(one.cluster_of, four.cluster_of);
    EXPECT_EQ(one.weights, four.weights);
}

TEST(Compression, FewOrEqualSignalsAreFine) {
    const std::vector<float> equal(40 * 6, 2.5F);
    const auto same = compress(equal, 6, {.clusters = 4, .vectors = 2});
    EXPECT_EQ(same.squared_error, 0);
    const std::vector<float> one{1, 2, 3};
    const auto single = compress(one, 3, {.clusters = 256, .vectors = 2});
    EXPECT_EQ(single.clusters, 1u);
    EXPECT_EQ(single.squared_error, 0);
    const auto means_only = compress(three_planes(30, 0.1F), 12, {.clusters = 3, .vectors = 0});
    EXPECT_GT(means_only.relative_error, 0);
    EXPECT_LT(means_only.relative_error, 0.2);
}

} // namespace
