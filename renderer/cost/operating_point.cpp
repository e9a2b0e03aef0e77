// Times that one run cannot tell apart do not choose.
#include "renderer/cost/operating_point.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace renderer::cost {

namespace {

std::vector<std::size_t> known(std::span<const Candidate> candidates) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (!std::isnan(candidates[i].error))
            indices.push_back(i);
    return indices;
}

template <class Key>
std::size_t least(const std::vector<std::size_t>& among, Key key) {
    return *std::min_element(among.begin(), among.end(),
                             [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
}

template <class Condition>
std::vector<std::size_t> those(const std::vector<std::size_t>& among, Condition condition) {
    std::vector<std::size_t> result;
    std::copy_if(among.begin(), among.end(), std::back_inserter(result), condition);
    return result;
}

} // namespace

std::optional<OperatingPoint> within_tolerance(std::span<const Candidate> candidates,
                                               double tolerance) {
    const auto all = known(candidates);
    if (all.empty())
        return std::nullopt;
    const auto good = those(all, [&](auto i) { return candidates[i].error <= tolerance; });
    if (good.empty())
        return OperatingPoint{
            least(all, [&](auto i) { return candidates[i].error; }), Rule::NothingIsGood, {}};
    const auto& fastest =
        candidates[least(good, [&](auto i) { return candidates[i].frame.median; })];
    auto as_fast =
        those(good, [&](auto i) { return candidates[i].frame.lower <= fastest.frame.upper; });
    const auto chosen = least(as_fast, [&](auto i) {
        const auto& c = candidates[i];
        return std::tuple(c.bytes, c.precompute_seconds, c.error, c.frame.median);
    });
    std::erase(as_fast, chosen);
    return OperatingPoint{chosen, Rule::GoodEnough, std::move(as_fast)};
}

std::optional<OperatingPoint> within_budget(std::span<const Candidate> candidates, double budget) {
    const auto all = known(candidates);
    if (all.empty())
        return std::nullopt;
    const auto fast = those(all, [&](auto i) { return candidates[i].frame.median <= budget; });
    if (fast.empty())
        return OperatingPoint{least(all, [&](auto i) { return candidates[i].frame.median; }),
                              Rule::NothingIsFast,
                              {}};
    return OperatingPoint{least(fast,
                                [&](auto i) {
                                    const auto& c = candidates[i];
                                    return std::tuple(c.error, c.frame.median, c.bytes);
                                }),
                          Rule::FastEnough,
                          {}};
}

} // namespace renderer::cost
