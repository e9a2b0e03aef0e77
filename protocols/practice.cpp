// Drawn from the last to the first, so that the end fits what follows it.  Partitions are stable
// because an order left to the standard library would differ between libraries.
#include "protocols/practice.h"

#include <algorithm>
#include <map>

namespace protocols {

namespace {

/// Whether `length` more can be drawn from these numbers of questions by scene without equal
/// neighbours, the first of them not `barred`.  A scene can fill every other place at most.
bool can_continue(const std::map<int, int>& left, int length, std::optional<int> barred) {
    int places = 0;
    for (const auto& [scene, count] : left)
        places += std::min(count, scene == barred ? length / 2 : (length + 1) / 2);
    return places >= length;
}

} // namespace

std::vector<std::size_t> draw_practice(std::span<const Question> questions,
                                       std::span<const std::size_t> pool,
                                       int count,
                                       std::optional<int> next_scene,
                                       Rng& rng,
                                       const Wanted& wanted) {
    EXPECTS(count == 0 || !pool.empty());
    std::vector<std::size_t> items;
    while (items.size() < static_cast<std::size_t>(count))
        items.insert(items.end(), pool.begin(), pool.end());
    std::map<int, int> left;
    for (const auto item : items)
        ++left[questions[item].scene];

    std::vector<std::size_t> drawn;
    for (auto barred = next_scene; static_cast<int>(drawn.size()) < count;) {
        const int after_this = count - static_cast<int>(drawn.size()) - 1;
        const auto keeps_the_rule = [&](std::size_t item) {
            const int scene = questions[item].scene;
            --left[scene];
            const bool keeps = scene != barred && can_continue(left, after_this, scene);
            ++left[scene];
            return keeps;
        };
        auto last = std::stable_partition(items.begin(), items.end(), keeps_the_rule);
        if (last == items.begin()) // somewhere it must break: not here, if that can be
            last = std::stable_partition(items.begin(), items.end(), [&](std::size_t item) {
                return questions[item].scene != barred;
            });
        if (last == items.begin())
            last = items.end();
        if (const auto here = wanted.find(after_this); here != wanted.end())
            if (const auto last_wanted = std::stable_partition(
                    items.begin(), last,
                    [&](std::size_t item) { return here->second(questions[item]); });
                last_wanted != items.begin())
                last = last_wanted;
        const auto place =
            items.begin() + static_cast<std::ptrdiff_t>(
                                draw_below(rng, static_cast<std::uint64_t>(last - items.begin())));
        barred = questions[*place].scene;
        --left[*barred];
        drawn.push_back(*place);
        items.erase(place);
    }
    std::reverse(drawn.begin(), drawn.end());
    return drawn;
}

} // namespace protocols
