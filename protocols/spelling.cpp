// Edit distance, row by row.
#include "protocols/spelling.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace protocols {

namespace {

std::size_t edit_distance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < from.size(); ++i) {
        auto diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const auto replaced = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

} // namespace

std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> names) {
    std::optional<std::string> nearest;
    auto least = std::max<std::size_t>(1, (word.size() + 1) / 3) + 1;
    for (const auto& name : names)
        if (const auto distance = edit_distance(word, name); distance < least) {
            least = distance;
            nearest = name;
        }
    return nearest;
}

} // namespace protocols
