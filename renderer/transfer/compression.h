// Clustered principal components: many similar vectors as a few points and directions for each
// cluster, and a few weights for each vector.  [Sloan2003]
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace renderer::transfer {

struct CompressionOptions {
    std::size_t clusters = 256;
    std::size_t vectors = 6; ///< principal vectors of a cluster, 0..dimension
    std::uint64_t seed = 1;  ///< of the first clusters' choice
};

/// Signal v is about mean(k) + sum_j weights[v * vectors + j] direction_j(k), k = cluster_of[v].
struct CompressedSignals {
    std::size_t dimension = 0; ///< floats of one signal
    std::size_t clusters = 0, vectors = 0;
    std::vector<float> representatives; ///< [(k * (vectors + 1) + j) * dimension + i]: the mean at
                                        ///< j = 0, then orthonormal directions
    std::vector<std::uint32_t> cluster_of; ///< per signal
    std::vector<float> weights;
    double squared_error = 0;    ///< sum over signals of |signal - approximation|^2, as stored
    double relative_error = 0;   ///< root of squared_error over the signals' own sum of squares
    std::vector<double> history; ///< squared error after each fit; it never grows
    bool converged = false;      ///< the last fit changed it by less than 1e-4 of itself
};

/// k-means, then principal components of each cluster and reassignment to the nearest affine
/// subspace by turns.  A signal may move to one of the 16 clusters whose means are nearest to its
/// own's; directions that hold less than 1e-9 of the energy are left out while clusters are sought.
/// Deterministic: the result does not depend on the number of threads.
/// Shapes: signals[v * dimension + i].
/// Errors: EXPECTS at least one signal and cluster, vectors <= dimension; more clusters than
/// signals are cut to as many.
CompressedSignals compress(std::span<const float> signals,
                           std::size_t dimension,
                           const CompressionOptions& options = {});

/// The approximation of signal v; `out` has `dimension` elements.
void decompress(const CompressedSignals& compressed, std::size_t v, std::span<float> out);

} // namespace renderer::transfer
