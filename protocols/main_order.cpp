// Scenes first, by `draw_sequence`; then each scene's questions are dealt to its places.
#include "protocols/main_order.h"

#include "protocols/order.h"

#include <algorithm>

namespace protocols {

namespace {

using Indices = std::vector<std::size_t>;

/// Each kind of dealing is tried this often: of a session in which nine pairs return four times,
/// uniform dealing is clean once in ten thousand, dealing apart nearly always.
constexpr int tries = 100;

bool returns_soon(std::span<const std::size_t> so_far, std::size_t question) {
    const auto recent = so_far.last(std::min<std::size_t>(so_far.size(), repeat_gap));
    return std::find(recent.begin(), recent.end(), question) != recent.end();
}

int count_close_repeats(const Indices& order) {
    int close = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
        close += returns_soon(std::span(order).first(i), order[i]) ? 1 : 0;
    return close;
}

/// Every deal equally likely.
Indices
deal_uniformly(const std::vector<int>& scenes, std::vector<Indices> questions_of, Rng& rng) {
    for (auto& questions : questions_of)
        shuffle(std::span(questions), rng);
    Indices order;
    for (const auto scene : scenes) {
        auto& questions = questions_of[static_cast<std::size_t>(scene)];
        order.push_back(questions.back());
        questions.pop_back();
    }
    return order;
}

/// Place by place, among those that do not return too soon; among all where there is none.  The
/// partition is stable because an order left to the standard library would differ between
/// libraries.
Indices deal_apart(const std::vector<int>& scenes, std::vector<Indices> questions_of, Rng& rng) {
    Indices order;
    for (const auto scene : scenes) {
        auto& questions = questions_of[static_cast<std::size_t>(scene)];
        const auto late =
            std::stable_partition(questions.begin(), questions.end(),
                                  [&](auto question) { return !returns_soon(order, question); });
        const auto choices = late == questions.begin() ? questions.end() : late;
        const auto chosen =
            draw_below(rng, static_cast<std::uint64_t>(choices - questions.begin()));
        const auto place = questions.begin() + static_cast<std::ptrdiff_t>(chosen);
        order.push_back(*place);
        questions.erase(place);
    }
    return order;
}

} // namespace

MainOrder draw_main_order(std::span<const Question> questions, int repetitions, Rng& rng) {
    EXPECTS(repetitions > 0);
    std::vector<Indices> questions_of; // by scene, each as often as it is asked
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const auto scene = static_cast<std::size_t>(questions[i].scene);
        questions_of.resize(std::max(questions_of.size(), scene + 1));
        questions_of[scene].insert(questions_of[scene].end(), static_cast<std::size_t>(repetitions),
                                   i);
    }
    std::vector<int> counts;
    for (const auto& asked : questions_of)
        counts.push_back(static_cast<int>(asked.size()));
    const auto scenes = draw_sequence(counts, rng);

    auto best = deal_uniformly(scenes, questions_of, rng);
    int fewest = count_close_repeats(best);
    for (int i = 1; i < 2 * tries && fewest > 0; ++i) {
        auto order = i < tries ? deal_uniformly(scenes, questions_of, rng)
                               : deal_apart(scenes, questions_of, rng);
        if (const int close = count_close_repeats(order); close < fewest) {
            fewest = close;
            best = std::move(order);
        }
    }
    return {std::move(best), least_equal_neighbours(counts), fewest};
}

} // namespace protocols
