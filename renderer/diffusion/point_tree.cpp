// The octree's construction, and the dipole spread over it.
#include "renderer/diffusion/point_tree.h"

#include "renderer/contract.h"
#include "renderer/diffusion/block_loop.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace renderer::diffusion {

namespace {

constexpr std::size_t samples_per_leaf = 8;
constexpr int deepest = 24; // halvings: coincident samples share a leaf in the end
constexpr std::size_t receivers_per_block = 64;

/// R_d of the three channels with everything that does not depend on distance worked out, in
/// float: the sum over a surface needs no more than its six digits.
class Kernel {
  public:
    explicit Kernel(const std::array<Dipole, 3>& dipoles) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto& d = dipoles[c];
            const double factor = d.alpha / (4 * std::numbers::pi);
            terms_[2 * c] = term(d.sigma_tr, d.z_real, factor);
            terms_[2 * c + 1] = term(d.sigma_tr, d.z_virtual, factor);
        }
    }

    std::array<float, 3> operator()(float squared_distance) const {
        std::array<float, 3> r{};
        for (std::size_t t = 0; t < terms_.size(); ++t) {
            const auto& [sigma_tr, z_squared, strength] = terms_[t];
            const float d_squared = squared_distance + z_squared;
            const float d = std::sqrt(d_squared);
            r[t / 2] += strength * (sigma_tr * d + 1) * std::exp(-sigma_tr * d) / (d * d_squared);
        }
        return r;
    }

  private:
    struct Term {
        float sigma_tr = 0, z_squared = 1, strength = 0;
    };

    static Term term(double sigma_tr, double z, double factor) {
        return {static_cast<float>(sigma_tr), static_cast<float>(z * z),
                static_cast<float>(factor * z)};
    }

    std::array<Term, 6> terms_;
};

} // namespace

struct PointTree::Builder {
    PointTree& tree;
    const SurfaceSamples& samples;
    std::span<const float> payload;
    std::vector<std::uint32_t> order;

    glm::vec3 relative(std::uint32_t sample) const {
        return glm::vec3(samples.centroids[sample] - tree.centre_);
    }

    /// Sorts order[begin..end) by octant around `middle`; the octants' ends.
    std::array<std::size_t, 8> split(std::size_t begin, std::size_t end, glm::vec3 middle) {
        std::array<std::vector<std::uint32_t>, 8> octants;
        for (auto i = begin; i < end; ++i) {
            const auto p = relative(order[i]);
            const auto octant = static_cast<std::size_t>((p.x > middle.x) + 2 * (p.y > middle.y) +
                                                         4 * (p.z > middle.z));
            octants[octant].push_back(order[i]);
        }
        std::array<std::size_t, 8> ends{};
        for (std::size_t k = 0, at = begin; k < 8; ++k) {
            std::copy(octants[k].begin(), octants[k].end(),
                      order.begin() + static_cast<std::ptrdiff_t>(at));
            ends[k] = at += octants[k].size();
        }
        return ends;
    }

    /// Sums and means over order[begin..end) into the node `at`.
    void summarise(std::uint32_t at, std::size_t begin, std::size_t end) {
        Node& node = tree.nodes_[at];
        node.low = node.high = relative(order[begin]);
        std::vector<double> row(tree.columns_);
        glm::dvec3 weighted(0), plain(0);
        double weights = 0, area = 0;
        for (auto i = begin; i < end; ++i) {
            const auto sample = order[i];
            const glm::dvec3 p = relative(sample);
            node.low = glm::min(node.low, relative(sample));
            node.high = glm::max(node.high, relative(sample));
            const double a = samples.areas[sample];
            const float* values = &payload[sample * tree.columns_];
            for (std::size_t k = 0; k < tree.columns_; ++k)
                row[k] += a * static_cast<double>(values[k]);
            const double weight = a * std::abs(static_cast<double>(values[0]));
            weighted += weight * p;
            weights += weight;
            plain += p;
            area += a;
        }
        node.area = static_cast<float>(area);
        node.centroid = weights > 0 ? weighted / weights : plain / static_cast<double>(end - begin);
        for (const double value : row)
            tree.node_rows_.push_back(static_cast<float>(value));
    }

    void add_leaf(Node& leaf, std::size_t begin, std::size_t end) {
        leaf.begin = static_cast<std::uint32_t>(begin);
        leaf.end = static_cast<std::uint32_t>(end);
        for (auto i = begin; i < end; ++i) {
            const auto sample = order[i];
            tree.positions_.push_back(relative(sample));
            for (std::size_t k = 0; k < tree.columns_; ++k)
                tree.sample_rows_.push_back(
                    static_cast<float>(samples.areas[sample] *
                                       static_cast<double>(payload[sample * tree.columns_ + k])));
        }
    }

    void add(std::size_t begin, std::size_t end, glm::vec3 middle, float half, int depth) {
        const auto at = static_cast<std::uint32_t>(tree.nodes_.size());
        tree.nodes_.emplace_back();
        summarise(at, begin, end);
        if (end - begin <= samples_per_leaf || depth == deepest) {
            add_leaf(tree.nodes_[at], begin, end);
        } else {
            const auto ends = split(begin, end, middle);
            for (std::size_t k = 0, from = begin; k < 8; from = ends[k++])
                if (from < ends[k]) {
                    const glm::vec3 side(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
                    add(from, ends[k], middle + 0.5F * half * side, 0.5F * half, depth + 1);
                }
        }
        tree.nodes_[at].next = static_cast<std::uint32_t>(tree.nodes_.size());
    }
};

PointTree::PointTree(const SurfaceSamples& samples,
                     std::span<const float> payload,
                     std::size_t columns)
    : columns_(columns) {
    EXPECTS(columns >= 1 && !samples.centroids.empty());
    EXPECTS(samples.areas.size() == samples.centroids.size());
    EXPECTS(payload.size() == samples.centroids.size() * columns);
    glm::dvec3 low = samples.centroids.front(), high = low;
    for (const auto& p : samples.centroids) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    centre_ = 0.5 * (low + high);
    const auto size = high - low;
    const auto half = static_cast<float>(0.5 * std::max({size.x, size.y, size.z}));
    Builder builder{*this, samples, payload, std::vector<std::uint32_t>(samples.centroids.size())};
    std::iota(builder.order.begin(), builder.order.end(), 0u);
    builder.add(0, builder.order.size(), glm::vec3(0), half, 0);
}

std::vector<float> spread(const PointTree& tree,
                          const std::array<Dipole, 3>& kernels,
                          std::span<const glm::dvec3> receivers,
                          double opening,
                          const Progress& progress) {
    EXPECTS(opening >= 0);
    const Kernel kernel(kernels);
    const std::size_t n = tree.columns();
    std::vector<float> result(receivers.size() * 3 * n);
    const bool finished = for_each_block(
        receivers.size(), receivers_per_block, progress, [&](std::size_t begin, std::size_t end) {
            for (auto v = begin; v < end; ++v) {
                float* out = &result[v * 3 * n];
                tree.for_each_source(receivers[v], opening, [&](float squared, const float* row) {
                    const auto [r, g, b] = kernel(squared);
                    for (std::size_t k = 0; k < n; ++k) {
                        out[k] += r * row[k];
                        out[n + k] += g * row[k];
                        out[2 * n + k] += b * row[k];
                    }
                });
            }
        });
    return finished ? result : std::vector<float>{};
}

} // namespace renderer::diffusion
