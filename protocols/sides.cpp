// Sides by closed walks.  Conditions are vertices and comparisons are edges; a walk that returns to
// where it began leaves every vertex as often as it enters it, and whoever is left is on the left.
//
// Walks close only where all degrees are even.  So each (scene, condition) of odd degree gets one
// extra edge to its condition's hub, each hub of odd degree one to a last vertex, and that one is
// even because edges have two ends.  Leaving the extra edges out costs each (scene, condition) at
// most one, and each hub, whose own edges balance to one, keeps a condition's total within one.
#include "protocols/sides.h"

#include <algorithm>

namespace protocols {

namespace {

struct Edge {
    std::size_t from = 0, to = 0; // as built; a walk may take it the other way
    bool walked = false;
    bool turned = false;
};

class BalancedGraph {
  public:
    explicit BalancedGraph(std::span<const Comparison> comparisons) {
        int scenes = 0, conditions = 0;
        for (const auto& [scene, first, second] : comparisons) {
            EXPECTS(scene >= 0 && first >= 0 && second >= 0 && first != second);
            scenes = std::max(scenes, scene + 1);
            conditions = std::max({conditions, first + 1, second + 1});
        }
        const auto width = static_cast<std::size_t>(conditions);
        const auto hubs = static_cast<std::size_t>(scenes) * width;
        incident_.resize(hubs + width + 1);
        for (const auto& [scene, first, second] : comparisons) {
            const auto row = static_cast<std::size_t>(scene) * width;
            join(row + static_cast<std::size_t>(first), row + static_cast<std::size_t>(second));
        }
        for (std::size_t vertex = 0; vertex < hubs; ++vertex)
            even_out(vertex, hubs + vertex % width);
        for (std::size_t hub = hubs; hub < hubs + width; ++hub)
            even_out(hub, hubs + width);
    }

    /// Walks every edge once, in closed walks, each in a random direction.
    void walk(Rng& rng) {
        for (auto& edges : incident_)
            shuffle(std::span(edges), rng);
        for (std::size_t start = 0; start < incident_.size(); ++start)
            while (has_unwalked(start))
                walk_from(start, draw_coin(rng));
    }

    bool turned(std::size_t edge) const { return edges_[edge].turned; }

  private:
    void join(std::size_t from, std::size_t to) {
        incident_[from].push_back(edges_.size());
        incident_[to].push_back(edges_.size());
        edges_.push_back({from, to});
    }

    void even_out(std::size_t vertex, std::size_t other) {
        if (incident_[vertex].size() % 2 == 1)
            join(vertex, other);
    }

    bool has_unwalked(std::size_t vertex) {
        auto& edges = incident_[vertex];
        while (!edges.empty() && edges_[edges.back()].walked)
            edges.pop_back();
        return !edges.empty();
    }

    /// Until it is stuck, which with even degrees it can only be where it began.
    void walk_from(std::size_t vertex, bool backwards) {
        while (has_unwalked(vertex)) {
            auto& edge = edges_[incident_[vertex].back()];
            edge.walked = true;
            edge.turned = (edge.to == vertex) != backwards;
            vertex = edge.to == vertex ? edge.from : edge.to;
        }
    }

    std::vector<Edge> edges_;
    std::vector<std::vector<std::size_t>> incident_; // edges at each vertex
};

} // namespace

std::vector<Side> draw_sides(std::span<const Comparison> comparisons, Rng& rng) {
    BalancedGraph graph(comparisons);
    graph.walk(rng);
    std::vector<Side> sides;
    for (std::size_t i = 0; i < comparisons.size(); ++i)
        sides.push_back(graph.turned(i) ? Side::Right : Side::Left);
    return sides;
}

} // namespace protocols
