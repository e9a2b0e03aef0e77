#include "analysis/vote_table.h"

#include "protocols/contract.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace analysis {

std::uint32_t Dictionary::code(std::string_view name) {
    if (last_ < names_.size() && names_[last_] == name)
        return last_;
    if (const auto known = codes_.find(name); known != codes_.end())
        return last_ = known->second;
    const auto next = static_cast<std::uint32_t>(names_.size());
    last_ = next;
    names_.emplace_back(name);
    codes_.emplace(std::string(name), next);
    return next;
}

std::int64_t Dictionary::find(std::string_view name) const {
    const auto known = codes_.find(name);
    return known == codes_.end() ? -1 : static_cast<std::int64_t>(known->second);
}

VoteTable empty_vote_table(std::vector<std::string> factor_names) {
    VoteTable table;
    table.factors.resize(factor_names.size());
    table.factor.resize(factor_names.size());
    table.factor_names = std::move(factor_names);
    return table;
}

void reserve_votes(VoteTable& table, std::size_t votes) {
    for (auto* column : {&table.observer, &table.session})
        column->reserve(votes);
    for (auto& column : table.factor)
        column.reserve(votes);
    for (auto* column : {&table.left, &table.right})
        column->reserve(votes);
    table.chosen.reserve(votes);
    for (auto* column : {&table.trial, &table.response_ms})
        column->reserve(votes);
}

void append_vote(VoteTable& table, const VoteRow& row) {
    EXPECTS(row.scene.size() == table.factors.size());
    table.observer.push_back(table.observers.code(row.observer));
    table.session.push_back(table.sessions.code(row.session));
    for (std::size_t f = 0; f < row.scene.size(); ++f)
        table.factor[f].push_back(table.factors[f].code(row.scene[f]));
    table.left.push_back(static_cast<std::uint16_t>(table.conditions.code(row.left)));
    table.right.push_back(static_cast<std::uint16_t>(table.conditions.code(row.right)));
    table.chosen.push_back(row.chosen);
    table.trial.push_back(row.trial);
    table.response_ms.push_back(row.response_ms);
}

Expected<VoteTable>
vote_table(std::vector<std::string> factor_names, std::span<const VoteRow> rows, Repeats repeats) {
    auto table = empty_vote_table(std::move(factor_names));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].left == rows[i].right)
            return tl::unexpected(fmt::format("vote {}: left and right are both '{}', expected two "
                                              "different conditions",
                                              i + 1, rows[i].left));
        append_vote(table, rows[i]);
    }
    if (repeats == Repeats::Refuse)
        if (const auto [first, second] = first_repeat(table); second >= 0)
            return tl::unexpected(fmt::format(
                "vote {}: {} already answered this question in vote {}, expected one vote per "
                "observer, session, scene and pair",
                second + 1, rows[static_cast<std::size_t>(second)].observer, first + 1));
    return table;
}

Expected<VoteTable> with_condition_order(VoteTable table, std::span<const std::string> order) {
    Dictionary ordered;
    for (const auto& name : order) {
        if (table.conditions.find(name) < 0)
            return tl::unexpected(fmt::format("condition '{}' is in the order but has no votes; "
                                              "the votes are about: {}",
                                              name, fmt::join(table.conditions.names(), ", ")));
        if (ordered.find(name) >= 0)
            return tl::unexpected(fmt::format("condition '{}' stands twice in the order", name));
        ordered.code(name);
    }
    for (const auto& name : table.conditions.names())
        if (ordered.find(name) < 0)
            return tl::unexpected(
                fmt::format("condition '{}' has votes but is not in the order: {}", name,
                            fmt::join(order, ", ")));
    const auto recode = [&](std::vector<std::uint16_t>& codes) {
        for (auto& code : codes)
            code = static_cast<std::uint16_t>(ordered.find(table.conditions.name(code)));
    };
    recode(table.left);
    recode(table.right);
    table.conditions = std::move(ordered);
    return table;
}

namespace {

// The cell of a question: observer, session, scene and unordered pair in mixed radix.  Nothing
// when 64 bits do not hold it, which takes more levels than anyone has votes.
struct QuestionCode {
    std::vector<std::uint64_t> radix;

    explicit QuestionCode(const VoteTable& table) {
        const auto t = static_cast<std::uint64_t>(table.conditions.size());
        radix = {table.sessions.size()};
        for (const auto& levels : table.factors)
            radix.push_back(levels.size());
        radix.push_back(t * t);
    }

    std::uint64_t operator()(const VoteTable& table, std::size_t vote) const {
        std::uint64_t code = table.observer[vote];
        code = code * radix[0] + table.session[vote];
        for (std::size_t f = 0; f < table.factor.size(); ++f)
            code = code * radix[f + 1] + table.factor[f][vote];
        const auto [low, high] = std::minmax(table.left[vote], table.right[vote]);
        return code * radix.back() + low * table.conditions.size() + high;
    }

    double cells(const VoteTable& table) const {
        auto product = static_cast<double>(table.observers.size());
        for (const auto r : radix)
            product *= static_cast<double>(r);
        return product;
    }
};

constexpr double bitmap_cells = 268435456.0; // 2^28 bits: 32 MiB

} // namespace

std::pair<std::int64_t, std::int64_t> first_repeat(const VoteTable& table) {
    const QuestionCode code(table);
    EXPECTS(code.cells(table) < 9e18);
    std::uint64_t repeated = 0;
    std::int64_t second = -1;
    if (code.cells(table) <= bitmap_cells) {
        std::vector<bool> seen(static_cast<std::size_t>(code.cells(table)));
        for (std::size_t i = 0; i < table.size() && second < 0; ++i) {
            const auto cell = code(table, i);
            if (seen[cell]) {
                repeated = cell;
                second = static_cast<std::int64_t>(i);
            }
            seen[cell] = true;
        }
    } else {
        std::vector<std::pair<std::uint64_t, std::int64_t>> cells(table.size());
        for (std::size_t i = 0; i < table.size(); ++i)
            cells[i] = {code(table, i), static_cast<std::int64_t>(i)};
        std::sort(cells.begin(), cells.end());
        for (std::size_t i = 1; i < cells.size(); ++i)
            if (cells[i].first == cells[i - 1].first && (second < 0 || cells[i].second < second)) {
                repeated = cells[i].first;
                second = cells[i].second;
            }
    }
    if (second < 0)
        return {-1, -1};
    std::int64_t first = 0;
    while (code(table, static_cast<std::size_t>(first)) != repeated)
        ++first;
    return {first, second};
}

} // namespace analysis
