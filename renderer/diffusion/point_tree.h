// Surface samples in an octree whose nodes stand for all they hold: sums over many far samples
// become one term.  [JensenBuhler2002]
#pragma once

#include "renderer/diffusion/dipole.h"
#include "renderer/diffusion/surface_samples.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace renderer::diffusion {

/// Called as blocks of work are finished, by one thread at a time, with growing fractions up to 1;
/// false stops the computation.
using Progress = std::function<bool(double fraction)>;

class PointTree {
  public:
    /// Copies what it needs.  A node is one sample with the area of all its samples, at their
    /// centroid weighted by area times |payload column 0|.
    /// Shapes: payload[sample * columns + column], any quantity per area.
    /// Errors: EXPECTS columns >= 1 and one row of payload for each sample, at least one.
    PointTree(const SurfaceSamples& samples, std::span<const float> payload, std::size_t columns);

    /// Calls `visit(squared distance, row)` for every node or sample that stands for itself, where
    /// a row is the sum of area times payload.  A node is opened when the point is inside its box
    /// or the solid angle area / distance^2 exceeds `opening`: 0 visits every sample.
    template <class Visit>
    void for_each_source(glm::dvec3 point, double opening, Visit visit) const;

    std::size_t columns() const { return columns_; }

  private:
    struct Node {
        glm::vec3 centroid, low, high; // relative to the tree's centre
        float area = 0;
        std::uint32_t begin = 0, end = 0; // samples, for a leaf; empty for others
        std::uint32_t next = 0;           // the node after all below this one
    };

    struct Builder;

    std::size_t columns_;
    glm::dvec3 centre_{};
    std::vector<Node> nodes_;          // depth first
    std::vector<glm::vec3> positions_; // in the order of the leaves
    std::vector<float> sample_rows_, node_rows_;
};

/// For every receiver and colour channel, the payload spread by the dipole:
/// sum over samples of area R_d(distance) payload.  On all threads; each receiver's sum is taken in
/// one order, so the result does not depend on their number.
/// Shapes: result[(receiver * 3 + channel) * columns + column]; empty when `progress` stopped it.
/// Units: the kernels' unit of length is that of the positions.
std::vector<float> spread(const PointTree& tree,
                          const std::array<Dipole, 3>& kernels,
                          std::span<const glm::dvec3> receivers,
                          double opening,
                          const Progress& progress = {});

template <class Visit>
void PointTree::for_each_source(glm::dvec3 point, double opening, Visit visit) const {
    const glm::vec3 p(point - centre_);
    const auto squared_distance = [&](glm::vec3 q) {
        const glm::vec3 away = q - p;
        return away.x * away.x + away.y * away.y + away.z * away.z;
    };
    const auto eps = static_cast<float>(opening);
    for (std::uint32_t at = 0; at < nodes_.size();) {
        const Node& node = nodes_[at];
        const float squared = squared_distance(node.centroid);
        const bool inside = p.x >= node.low.x && p.x <= node.high.x && p.y >= node.low.y &&
                            p.y <= node.high.y && p.z >= node.low.z && p.z <= node.high.z;
        if (!inside && node.area <= eps * squared) {
            visit(squared, &node_rows_[at * columns_]);
            at = node.next;
        } else if (node.begin < node.end) {
            for (auto i = node.begin; i < node.end; ++i)
                visit(squared_distance(positions_[i]), &sample_rows_[i * columns_]);
            at = node.next;
        } else {
            ++at;
        }
    }
}

} // namespace renderer::diffusion
