#include "analysis/anova/letters.h"

#include "protocols/contract.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace analysis::anova {

namespace {

using Column = std::uint64_t; // bit r: the item ranked r shares this letter

bool inside(Column a, Column b) {
    return (a & ~b) == 0;
}

// Each column that holds both gives way to two, each without one of them; what another column holds
// is dropped.  Columns that stay hold nothing of each other, nor does a new one hold an old one.
std::vector<Column> inserted(const std::vector<Column>& columns, Column one, Column other) {
    std::vector<Column> next, fresh;
    for (const auto column : columns) {
        if (inside(one | other, column)) {
            fresh.push_back(column & ~one);
            fresh.push_back(column & ~other);
        } else {
            next.push_back(column);
        }
    }
    std::sort(fresh.begin(), fresh.end());
    fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
    const auto old = next.size();
    for (const auto column : fresh) {
        const auto holds = [&](Column holder) {
            return holder != column && inside(column, holder);
        };
        if (std::none_of(next.begin(), next.begin() + static_cast<std::ptrdiff_t>(old), holds) &&
            std::none_of(fresh.begin(), fresh.end(), holds))
            next.push_back(column);
    }
    return next;
}

// Best member first, then the next: the lowest rank that only one of the two holds decides.
bool better(Column a, Column b) {
    const Column difference = a ^ b;
    return (a & difference & (~difference + 1)) != 0;
}

} // namespace

std::string letter(std::size_t column) {
    std::string word;
    for (auto rest = column + 1; rest > 0; rest = (rest - 1) / 26)
        word.insert(word.begin(), static_cast<char>('a' + (rest - 1) % 26));
    return word;
}

std::optional<std::vector<std::string>>
compact_letters(std::span<const std::size_t> ranked,
                std::span<const std::pair<std::size_t, std::size_t>> significant) {
    const auto items = ranked.size();
    if (items > 64)
        return std::nullopt;
    std::vector<Column> bit(items);
    for (std::size_t r = 0; r < items; ++r)
        bit.at(ranked[r]) = Column{1} << r;
    std::vector<Column> columns{items == 64 ? ~Column{0} : (Column{1} << items) - 1};
    for (const auto& [one, other] : significant) {
        EXPECTS(one < items && other < items && one != other);
        columns = inserted(columns, bit[one], bit[other]);
        if (columns.size() > letter_column_limit)
            return std::nullopt;
    }
    std::sort(columns.begin(), columns.end(), better);
    std::vector<std::string> letters(items);
    for (std::size_t c = 0; c < columns.size(); ++c)
        for (std::size_t item = 0; item < items; ++item)
            if ((columns[c] & bit[item]) != 0)
                letters[item] += letter(c);
    return letters;
}

std::vector<std::string>
letters_by_means(std::span<const double> means,
                 std::span<const std::pair<std::size_t, std::size_t>> significant) {
    std::vector<std::size_t> ranked(means.size());
    std::iota(ranked.begin(), ranked.end(), std::size_t{0});
    std::stable_sort(ranked.begin(), ranked.end(),
                     [&](auto a, auto b) { return means[a] > means[b]; });
    return compact_letters(ranked, significant).value_or(std::vector<std::string>{});
}

} // namespace analysis::anova
