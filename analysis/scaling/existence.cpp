// Tarjan's algorithm finishes the strong components from the dominated upwards.
#include "analysis/scaling/existence.h"

#include "protocols/contract.h"

#include <algorithm>
#include <utility>

namespace analysis::scaling {
namespace {

using Components = std::vector<std::vector<std::size_t>>;

class StrongComponents {
  public:
    explicit StrongComponents(const WinCounts& counts)
        : counts_(counts), order_(counts.conditions, unseen), lowest_(counts.conditions),
          open_(counts.conditions, false) {
        for (std::size_t i = 0; i < counts.conditions; ++i)
            if (order_[i] == unseen)
                visit(i);
        std::reverse(components_.begin(), components_.end());
    }

    Components take() { return std::move(components_); }

  private:
    static constexpr std::size_t unseen = static_cast<std::size_t>(-1);

    void visit(std::size_t i) { // as deep as there are conditions: dozens
        order_[i] = lowest_[i] = next_++;
        stack_.push_back(i);
        open_[i] = true;
        for (std::size_t j = 0; j < counts_.conditions; ++j) {
            if (j == i || counts_(i, j) == 0)
                continue;
            if (order_[j] == unseen)
                visit(j);
            if (open_[j])
                lowest_[i] = std::min(lowest_[i], lowest_[j]);
        }
        if (lowest_[i] == order_[i])
            close(i);
    }

    void close(std::size_t root) {
        auto& component = components_.emplace_back();
        do {
            component.push_back(stack_.back());
            open_[stack_.back()] = false;
            stack_.pop_back();
        } while (component.back() != root);
        std::sort(component.begin(), component.end());
    }

    const WinCounts& counts_;
    std::vector<std::size_t> order_, lowest_, stack_;
    std::vector<bool> open_;
    Components components_;
    std::size_t next_ = 0;
};

Components connected_components(const WinCounts& counts) {
    const std::size_t t = counts.conditions;
    std::vector<bool> seen(t, false);
    Components components;
    for (std::size_t start = 0; start < t; ++start) {
        if (seen[start])
            continue;
        auto& component = components.emplace_back(1, start);
        seen[start] = true;
        for (std::size_t at = 0; at < component.size(); ++at)
            for (std::size_t j = 0; j < t; ++j)
                if (!seen[j] && counts(component[at], j) + counts(j, component[at]) > 0) {
                    seen[j] = true;
                    component.push_back(j);
                }
        std::sort(component.begin(), component.end());
    }
    return components;
}

} // namespace

Existence existence(const WinCounts& counts) {
    EXPECTS(counts.wins.size() == counts.conditions * counts.conditions);
    auto connected = connected_components(counts);
    if (connected.size() > 1)
        return {Scale::Disconnected, std::move(connected)};
    auto strong = StrongComponents(counts).take();
    const Scale scale = strong.size() > 1 ? Scale::Separated : Scale::Finite;
    return {scale, std::move(strong)};
}

} // namespace analysis::scaling
