// What was chosen is compared with the best of its own method and with the best of all.
#include "experiment/cost/choices.h"

#include "renderer/cost/operating_point.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace experiment::cost {

using renderer::cost::Candidate;
using renderer::cost::OperatingPoint;
using renderer::cost::Rule;

namespace {

std::vector<Candidate> candidates(const SceneCost& scene, std::size_t light, ErrorKind kind) {
    std::vector<Candidate> all;
    for (const auto& row : scene.rows)
        all.push_back({row.frame_ms, error_of(row, light, kind), bytes_in_all(row),
                       row.precompute_seconds.value_or(0)});
    return all;
}

std::string cost_in_words(const Row& row) {
    return fmt::format("{:.3g} ms a frame, {} bytes at each of {} vertices{}", row.frame_ms.median,
                       row.bytes_per_vertex, row.vertices,
                       row.precompute_seconds
                           ? fmt::format(", {:.2g} s beforehand", *row.precompute_seconds)
                           : "");
}

std::size_t within(const std::vector<Candidate>& all, double tolerance) {
    return static_cast<std::size_t>(
        std::ranges::count_if(all, [&](const Candidate& c) { return c.error <= tolerance; }));
}

std::string why(const SceneCost& scene,
                const std::vector<Candidate>& all,
                const OperatingPoint& point,
                const Wish& wish) {
    const auto& row = scene.rows[point.chosen];
    const auto error = as_percent(all[point.chosen].error);
    switch (point.rule) {
    case Rule::GoodEnough: {
        auto text = fmt::format("{} of {} settings are within {}", within(all, *wish.tolerance),
                                all.size(), as_percent(*wish.tolerance));
        if (point.as_fast.empty())
            text += ", and this is the fastest of them";
        else
            text +=
                fmt::format("; {} of them are the fastest and cannot be told apart by time, and "
                            "this takes the least memory, then precomputation, then error",
                            point.as_fast.size() + 1);
        return text + fmt::format(": error {}, {}", error, cost_in_words(row));
    }
    case Rule::NothingIsGood:
        return fmt::format("no setting is within {}; this has the least error: {}, {}",
                           as_percent(*wish.tolerance), error, cost_in_words(row));
    case Rule::FastEnough:
        return fmt::format("the least error of the settings that draw a frame in {:.3g} ms: {}, {}",
                           *wish.budget_ms, error, cost_in_words(row));
    case Rule::NothingIsFast:
        return fmt::format("no setting draws a frame in {:.3g} ms; this is the fastest: {}, {}",
                           *wish.budget_ms, error, cost_in_words(row));
    }
    return "";
}

/// What going over to `other` would bring and take.
std::string exchange(const Row& now, const Row& other, double now_error, double other_error) {
    return fmt::format(
        "{}: error {} instead of {}, {:.2f} of the frame time, {} instead of {} bytes "
        "a vertex{}",
        full_name(other), as_percent(other_error), as_percent(now_error),
        other.frame_ms.median / now.frame_ms.median, other.bytes_per_vertex, now.bytes_per_vertex,
        other.vertices == now.vertices
            ? ""
            : fmt::format(" at {} instead of {} vertices", other.vertices, now.vertices));
}

template <class Condition>
std::optional<std::size_t> most_exact(const std::vector<Candidate>& all, Condition condition) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!std::isnan(all[i].error) && condition(i) && (!best || all[i].error < all[*best].error))
            best = i;
    return best;
}

std::string left_out(const SceneCost& scene,
                     const std::vector<Candidate>& all,
                     const OperatingPoint& point,
                     std::size_t light) {
    const auto& row = scene.rows[point.chosen];
    const double error = all[point.chosen].error;
    std::vector<std::string> words;
    const auto add = [&](std::optional<std::size_t> i) {
        if (i && *i != point.chosen && all[*i].error < error)
            words.push_back(exchange(row, scene.rows[*i], error, all[*i].error));
    };
    const auto own = most_exact(all, [&](auto i) { return scene.rows[i].method == row.method; });
    const auto best = most_exact(all, [](auto) { return true; });
    add(own);
    if (best != own)
        add(best);
    if (const auto& decision = row.lights[light].decision; !decision.empty())
        words.push_back("in its own words: " + decision);
    return words.empty() ? "nothing: no setting that was measured is more exact"
                         : fmt::format("{}", fmt::join(words, "; "));
}

std::optional<OperatingPoint> point_for(const std::vector<Candidate>& all, const Wish& wish) {
    return wish.budget_ms ? renderer::cost::within_budget(all, *wish.budget_ms)
                          : renderer::cost::within_tolerance(all, *wish.tolerance);
}

} // namespace

std::string as_percent(double share) {
    return fmt::format("{:.2g} %", 100 * share);
}

std::optional<Choice> choose(const SceneCost& scene, std::size_t light, const Wish& wish) {
    const auto all = candidates(scene, light, wish.error);
    const auto point = point_for(all, wish);
    if (!point)
        return std::nullopt;
    return Choice{point->chosen,
                  why(scene, all, *point, wish),
                  left_out(scene, all, *point, light),
                  all[point->chosen].error,
                  {}};
}

std::vector<Rung> ladder(const SceneCost& scene, std::size_t light, ErrorKind kind) {
    const auto all = candidates(scene, light, kind);
    std::vector<Rung> rungs;
    for (const double error : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5}) {
        const auto point = renderer::cost::within_tolerance(all, error);
        rungs.push_back({error, point && point->rule == Rule::GoodEnough
                                    ? std::optional(point->chosen)
                                    : std::nullopt});
    }
    return rungs;
}

} // namespace experiment::cost
