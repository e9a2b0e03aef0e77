// k-means and clustered principal components by covariances, cluster against cluster.
#include "renderer/transfer/compression.h"

#include "renderer/contract.h"
#include "renderer/splitmix.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace renderer::transfer {

namespace {

using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Signals = Eigen::Map<const Rows>; // a row for each signal
using Index = Eigen::Index;

constexpr std::size_t neighbours_searched = 16;
// Clusters are sought in the few directions that hold all but this part of the energy: transfer
// vectors fill a third of theirs, and an eigenproblem costs the cube.
constexpr double energy_left_out = 1e-9;
constexpr int most_kmeans_steps = 10; // a start, not a result
constexpr std::size_t most_fits = 100;
constexpr double smallest_change = 1e-4; // [Sloan2003] stops when the error stands still
// A move must gain more than float's rounding, or signals would hop between equals for ever.
constexpr float least_gain = 1e-5F;

/// An affine subspace: a point and orthonormal directions in the columns of `basis`.
struct Subspace {
    Eigen::VectorXf mean;
    Eigen::MatrixXf basis;
};

std::vector<std::vector<Index>> members_of(std::span<const std::uint32_t> cluster_of,
                                           std::size_t clusters) {
    std::vector<std::vector<Index>> members(clusters);
    for (std::size_t v = 0; v < cluster_of.size(); ++v)
        members[cluster_of[v]].push_back(static_cast<Index>(v));
    return members;
}

Rows gathered(const Signals& signals, const std::vector<Index>& members) {
    Rows rows(static_cast<Index>(members.size()), signals.cols());
    for (std::size_t i = 0; i < members.size(); ++i)
        rows.row(static_cast<Index>(i)) = signals.row(members[i]);
    return rows;
}

/// First means far from each other: each drawn with a chance proportional to the squared distance
/// from those before.  [Arthur2007]
Rows far_apart(const Signals& signals, std::size_t clusters, std::uint64_t seed) {
    Rows means(static_cast<Index>(clusters), signals.cols());
    std::vector<float> squared(static_cast<std::size_t>(signals.rows()),
                               std::numeric_limits<float>::infinity());
    Index chosen = static_cast<Index>(uniform(seed) * static_cast<double>(signals.rows()));
    for (Index k = 0; k < means.rows(); ++k) {
        means.row(k) = signals.row(chosen);
        tbb::parallel_for(Index{0}, signals.rows(), [&](Index v) {
            float& best = squared[static_cast<std::size_t>(v)];
            best = std::min(best, (signals.row(v) - means.row(k)).squaredNorm());
        });
        double left = uniform(seed) * std::accumulate(squared.begin(), squared.end(), 0.0);
        chosen = 0;
        while (chosen + 1 < signals.rows() &&
               (left -= static_cast<double>(squared[static_cast<std::size_t>(chosen)])) >= 0)
            ++chosen;
    }
    return means;
}

/// The nearest mean of every signal, in blocks that make one matrix product each.
void assign_to_means(const Signals& signals,
                     const Rows& means,
                     std::vector<std::uint32_t>& cluster_of) {
    constexpr Index per_block = 512;
    const Eigen::VectorXf half_norms = 0.5F * means.rowwise().squaredNorm();
    tbb::parallel_for(Index{0}, (signals.rows() + per_block - 1) / per_block, [&](Index block) {
        const Index begin = block * per_block, count = std::min(per_block, signals.rows() - begin);
        Rows closeness = signals.middleRows(begin, count) * means.transpose();
        closeness.rowwise() -= half_norms.transpose();
        for (Index i = 0; i < count; ++i) {
            Index best = 0;
            closeness.row(i).maxCoeff(&best);
            cluster_of[static_cast<std::size_t>(begin + i)] = static_cast<std::uint32_t>(best);
        }
    });
}

std::vector<std::uint32_t>
kmeans(const Signals& signals, std::size_t clusters, std::uint64_t seed) {
    Rows means = far_apart(signals, clusters, seed);
    std::vector<std::uint32_t> cluster_of(static_cast<std::size_t>(signals.rows()));
    for (int step = 0; step < most_kmeans_steps; ++step) {
        const auto before = cluster_of;
        assign_to_means(signals, means, cluster_of);
        if (cluster_of == before)
            break;
        const auto members = members_of(cluster_of, clusters);
        tbb::parallel_for(std::size_t{0}, clusters, [&](std::size_t k) {
            if (!members[k].empty())
                means.row(static_cast<Index>(k)) = gathered(signals, members[k]).colwise().mean();
        });
    }
    return cluster_of;
}

Eigen::MatrixXd covariance(const Rows& centred) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(centred.cols(), centred.cols());
    sum.selfadjointView<Eigen::Lower>().rankUpdate(centred.cast<double>().transpose());
    return sum;
}

/// The subspace of least squared distance to the rows, and that distance.  Covariance in double:
/// its square would cost float all its digits where a cluster is nearly flat.
double fit(const Rows& rows, Index vectors, Subspace& subspace) {
    subspace.mean = rows.cast<double>().colwise().mean().transpose().cast<float>();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        covariance(rows.rowwise() - subspace.mean.transpose()));
    subspace.basis = eigen.eigenvectors().rightCols(vectors).rowwise().reverse().cast<float>();
    return eigen.eigenvalues().head(rows.cols() - vectors).cwiseMax(0).sum();
}

/// What a cluster was fitted to last, and how well.
struct Fit {
    std::vector<Index> members;
    double error = 0;
};

/// Fits every cluster whose members have changed; the total squared error.
double fit_all(const Signals& signals,
               std::vector<std::vector<Index>> members,
               Index vectors,
               std::vector<Fit>& fits,
               std::vector<Subspace>& subspaces) {
    tbb::parallel_for(std::size_t{0}, members.size(), [&](std::size_t k) {
        if (members[k] == fits[k].members)
            return;
        fits[k].members = std::move(members[k]);
        fits[k].error = fits[k].members.empty()
                            ? 0
                            : fit(gathered(signals, fits[k].members), vectors, subspaces[k]);
    });
    double total = 0;
    for (const auto& each : fits)
        total += each.error;
    return total;
}

/// For each cluster the others whose means are nearest, itself first.
std::vector<std::vector<std::uint32_t>> near_clusters(const std::vector<Subspace>& subspaces) {
    const std::size_t count = std::min(neighbours_searched, subspaces.size());
    std::vector<std::vector<std::uint32_t>> near(subspaces.size());
    tbb::parallel_for(std::size_t{0}, subspaces.size(), [&](std::size_t k) {
        std::vector<std::pair<float, std::uint32_t>> others;
        for (std::uint32_t other = 0; other < subspaces.size(); ++other)
            others.emplace_back(
                other == k ? -1.0F : (subspaces[other].mean - subspaces[k].mean).squaredNorm(),
                other);
        std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count),
                          others.end());
        for (std::size_t i = 0; i < count; ++i)
            near[k].push_back(others[i].second);
    });
    return near;
}

/// Squared distances of rows to the subspaces of `near`, a column each, from one matrix product.
/// `origin` is near all of them: distances are differences of squares, and must not be of large
/// ones.
Rows squared_distances(const Rows& rows,
                       const Eigen::VectorXf& origin,
                       const std::vector<std::uint32_t>& near,
                       const std::vector<Subspace>& subspaces) {
    const Index per = subspaces[near[0]].basis.cols() + 1;
    Eigen::MatrixXf probes(rows.cols(), per * static_cast<Index>(near.size()));
    for (std::size_t k = 0; k < near.size(); ++k) {
        probes.col(static_cast<Index>(k) * per) = subspaces[near[k]].mean - origin;
        probes.middleCols(static_cast<Index>(k) * per + 1, per - 1) = subspaces[near[k]].basis;
    }
    const Rows centred = rows.rowwise() - origin.transpose();
    const Eigen::VectorXf squares = centred.rowwise().squaredNorm();
    const Rows products = centred * probes;
    Rows distances(rows.rows(), static_cast<Index>(near.size()));
    for (Index k = 0; k < distances.cols(); ++k) {
        const Eigen::VectorXf mean = probes.col(k * per);
        const Eigen::RowVectorXf along = mean.transpose() * probes.middleCols(k * per + 1, per - 1);
        distances.col(k) =
            squares - 2 * products.col(k * per) -
            (products.middleCols(k * per + 1, per - 1).rowwise() - along).rowwise().squaredNorm();
        distances.col(k).array() += mean.squaredNorm();
    }
    return distances;
}

/// Moves every signal to the nearest subspace among those near its own.
void reassign(const Signals& signals,
              const std::vector<Fit>& fits,
              const std::vector<Subspace>& subspaces,
              std::vector<std::uint32_t>& cluster_of) {
    const auto near = near_clusters(subspaces);
    tbb::parallel_for(std::size_t{0}, fits.size(), [&](std::size_t k) {
        const auto& members = fits[k].members;
        if (members.empty())
            return;
        const Rows rows = gathered(signals, members);
        const auto distances = squared_distances(rows, subspaces[k].mean, near[k], subspaces);
        for (Index v = 0; v < rows.rows(); ++v) {
            Index best = 0;
            const float least = distances.row(v).minCoeff(&best);
            const float slack =
                least_gain * (rows.row(v) - subspaces[k].mean.transpose()).squaredNorm();
            if (least + slack < distances(v, 0)) // the first is its own
                cluster_of[static_cast<std::size_t>(members[static_cast<std::size_t>(v)])] =
                    near[k][static_cast<std::size_t>(best)];
        }
    });
}

/// Coordinates in which signals are few numbers: signal = centre + directions * coordinates, but
/// for `left_out` of squared length in all.
struct Reduction {
    Eigen::VectorXf centre;
    Eigen::MatrixXf directions;
    double left_out = 0;
};

Reduction reduce(const Signals& signals, Index at_least) {
    Reduction reduction;
    reduction.centre = signals.cast<double>().colwise().mean().transpose().cast<float>();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        covariance(signals.rowwise() - reduction.centre.transpose()));
    const Eigen::VectorXd energies = eigen.eigenvalues().cwiseMax(0);
    Index dropped = 0;
    while (dropped < signals.cols() - at_least &&
           reduction.left_out + energies[dropped] <= energy_left_out * energies.sum())
        reduction.left_out += energies[dropped++];
    reduction.directions = eigen.eigenvectors().rightCols(signals.cols() - dropped).cast<float>();
    return reduction;
}

/// The subspaces in the signals' own coordinates.
void expand(const Reduction& reduction, std::vector<Subspace>& subspaces) {
    for (auto& subspace : subspaces) {
        subspace.mean = (reduction.centre + reduction.directions * subspace.mean).eval();
        subspace.basis = (reduction.directions * subspace.basis).eval();
    }
}

/// Representatives and weights as they will be used.
void store(const Signals& signals,
           const std::vector<Subspace>& subspaces,
           CompressedSignals& compressed) {
    const std::size_t row = compressed.dimension, per_cluster = compressed.vectors + 1;
    compressed.representatives.resize(subspaces.size() * per_cluster * row);
    for (std::size_t k = 0; k < subspaces.size(); ++k) {
        float* out = &compressed.representatives[k * per_cluster * row];
        Eigen::Map<Eigen::VectorXf>(out, subspaces[k].mean.size()) = subspaces[k].mean;
        Eigen::Map<Eigen::MatrixXf>(out + row, subspaces[k].basis.rows(),
                                    subspaces[k].basis.cols()) = subspaces[k].basis;
    }
    compressed.weights.resize(compressed.cluster_of.size() * compressed.vectors);
    tbb::parallel_for(std::size_t{0}, compressed.cluster_of.size(), [&](std::size_t v) {
        const auto& subspace = subspaces[compressed.cluster_of[v]];
        const Eigen::VectorXf weights =
            subspace.basis.transpose() *
            (signals.row(static_cast<Index>(v)).transpose() - subspace.mean);
        std::copy(weights.begin(), weights.end(),
                  compressed.weights.begin() + static_cast<std::ptrdiff_t>(v * compressed.vectors));
    });
}

/// What the stored numbers make of the signals.
void measure(std::span<const float> signals, CompressedSignals& compressed) {
    const std::size_t n = compressed.dimension;
    std::vector<float> approximation(n);
    double total = 0;
    for (std::size_t v = 0; v < compressed.cluster_of.size(); ++v) {
        decompress(compressed, v, approximation);
        for (std::size_t i = 0; i < n; ++i) {
            const double signal = signals[v * n + i];
            const double error = signal - static_cast<double>(approximation[i]);
            compressed.squared_error += error * error;
            total += signal * signal;
        }
    }
    compressed.relative_error = total > 0 ? std::sqrt(compressed.squared_error / total) : 0;
}

/// Fits and reassigns by turns until the error stands still; fills clusters and history.
std::vector<Subspace> find_subspaces(const Signals& signals,
                                     std::uint64_t seed,
                                     double left_out,
                                     CompressedSignals& compressed) {
    const auto vectors = static_cast<Index>(compressed.vectors);
    const Subspace nowhere{Eigen::VectorXf::Zero(signals.cols()),
                           Eigen::MatrixXf::Zero(signals.cols(), vectors)};
    std::vector<Subspace> subspaces(compressed.clusters, nowhere);
    std::vector<Fit> fits(compressed.clusters);
    auto& history = compressed.history;
    compressed.cluster_of = kmeans(signals, compressed.clusters, seed);
    while (true) {
        const double error =
            left_out + fit_all(signals, members_of(compressed.cluster_of, compressed.clusters),
                               vectors, fits, subspaces);
        compressed.converged =
            !history.empty() && history.back() - error <= smallest_change * history.back();
        history.push_back(error);
        if (compressed.converged || history.size() == most_fits)
            return subspaces;
        reassign(signals, fits, subspaces, compressed.cluster_of);
    }
}

} // namespace

CompressedSignals
compress(std::span<const float> values, std::size_t dimension, const CompressionOptions& options) {
    EXPECTS(dimension >= 1 && !values.empty() && values.size() % dimension == 0);
    EXPECTS(options.clusters >= 1 && options.vectors <= dimension);
    const std::size_t count = values.size() / dimension;
    const Signals signals(values.data(), static_cast<Index>(count), static_cast<Index>(dimension));
    CompressedSignals compressed{.dimension = dimension,
                                 .clusters = std::min(options.clusters, count),
                                 .vectors = options.vectors};
    const auto vectors = static_cast<Index>(options.vectors);
    const auto reduction = reduce(signals, std::max<Index>(vectors, 1));
    const Rows coordinates =
        (signals.rowwise() - reduction.centre.transpose()) * reduction.directions;
    auto subspaces =
        find_subspaces(Signals(coordinates.data(), coordinates.rows(), coordinates.cols()),
                       options.seed, reduction.left_out, compressed);
    expand(reduction, subspaces);
    store(signals, subspaces, compressed);
    measure(values, compressed);
    return compressed;
}

void decompress(const CompressedSignals& compressed, std::size_t v, std::span<float> out) {
    const std::size_t n = compressed.dimension;
    EXPECTS(v < compressed.cluster_of.size() && out.size() == n);
    const float* representative =
        &compressed.representatives[compressed.cluster_of[v] * (compressed.vectors + 1) * n];
    std::copy_n(representative, n, out.begin());
    for (std::size_t j = 0; j < compressed.vectors; ++j) {
        representative += n;
        for (std::size_t i = 0; i < n; ++i)
            out[i] += compressed.weights[v * compressed.vectors + j] * representative[i];
    }
}

} // namespace renderer::transfer
