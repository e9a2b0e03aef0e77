#include "analysis/anova/letters.h"

#include "protocols/contract.h"

#include <algorithm>
#include <cstdint>

namespace analysis::anova {

namespace {

using Column = std::uint64_t; // bit r: the item ranked r shares this letter

bool inside(Column a, Column b) {
    return (a & ~b) == 0;
}

// Drops every column that another one holds.
std::vector<Column> absorbed(std::vector<Column> columns) {
    std::sort(columns.begin(), columns.end());
    columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    std::vector<Column> kept;
    for (const auto column : columns)
        if (std::none_of(columns.begin(), columns.end(),
                         [&](Column other) { return other != column && inside(column, other); }))
            kept.push_back(column);
    return kept;
}

// Each column that holds both gives way to two, each without one of them.
std::vector<Column> inserted(const std::vector<Column>& columns, Column one, Column other) {
    std::vector<Column> next;
    for (const auto column : columns) {
        if (inside(one | other, column)) {
            next.push_back(column & ~one);
            next.push_back(column & ~other);
        } else {
            next.push_back(column);
        }
    }
    return absorbed(std::move(next));
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

} // namespace analysis::anova
