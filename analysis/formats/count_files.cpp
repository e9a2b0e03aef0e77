#include "analysis/formats/count_files.h"

#include "analysis/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

namespace analysis::formats {

namespace {

constexpr const char* sides_unknown = "the file does not say which condition was on the left: what "
                                      "is said of the left side is of the one named first";
constexpr const char* pooled_observers = "the file does not name observers: all votes count as one "
                                         "observer's, so nothing can be said of people in general";

std::optional<std::int64_t> count(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size() && value >= 0;
    return whole ? std::optional(value) : std::nullopt;
}

// Grows a table by counts; "" or what is wrong.
class Counter {
  public:
    explicit Counter(std::vector<std::string> factors)
        : table_(empty_vote_table(std::move(factors))) {}

    std::string add(VoteRow row, protocols::Choice chosen, std::int64_t votes) {
        if (row.left == row.right)
            return votes == 0
                       ? ""
                       : fmt::format("'{}' against itself, expected two conditions", row.left);
        if (votes > most_votes - static_cast<std::int64_t>(table_.size()))
            return fmt::format("more than {} votes", most_votes);
        row.chosen = chosen;
        for (std::int64_t vote = 0; vote < votes; ++vote)
            append_vote(table_, row);
        return {};
    }

    void know(std::string_view condition) { table_.conditions.code(condition); }

    void simulated() { table_.simulated = true; }

    void remark(std::string note) { table_.notes.push_back(std::move(note)); }

    Expected<VoteTable> finish(const std::string& name, bool observers_named) {
        if (table_.size() == 0)
            return tl::unexpected(fmt::format("{}:1: no votes", name));
        table_.notes.emplace_back(sides_unknown);
        if (!observers_named)
            table_.notes.emplace_back(pooled_observers);
        return std::move(table_);
    }

  private:
    VoteTable table_;
};

struct PairColumns {
    int first = -1, second = -1, first_wins = -1, second_wins = -1, ties = -1, observer = -1,
        session = -1, scope = -1, simulated = -1;
    std::vector<std::size_t> factors;
    std::vector<std::string> factor_names;
    std::size_t count = 0;
    bool named = false; ///< there is a header row
};

std::string read_pair_header(std::span<const std::string_view> fields, PairColumns& columns) {
    columns.count = fields.size();
    if (fields.size() == 2 && count(fields[0]) && count(fields[1])) {
        columns.first = 0;
        columns.second = 1;
        return {};
    }
    columns.named = true;
    const std::pair<std::string_view, int*> known[] = {
        {"winner", &columns.first},     {"loser", &columns.second},
        {"player1", &columns.first},    {"player2", &columns.second},
        {"win1", &columns.first_wins},  {"win2", &columns.second_wins},
        {"votes", &columns.first_wins}, {"count", &columns.first_wins},
        {"ties", &columns.ties},        {"observer", &columns.observer},
        {"subject", &columns.observer}, {"session", &columns.session},
        {"scope", &columns.scope},      {"simulated", &columns.simulated}};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto* found = std::find_if(std::begin(known), std::end(known),
                                         [&](const auto& k) { return k.first == fields[i]; });
        if (found == std::end(known)) {
            columns.factors.push_back(i);
            columns.factor_names.emplace_back(fields[i]);
        } else if (*found->second >= 0) {
            return fmt::format("column '{}' says again what another does, expected one", fields[i]);
        } else {
            *found->second = static_cast<int>(i);
        }
    }
    if (columns.first < 0 || columns.second < 0)
        return "no columns 'winner' and 'loser', or 'player1' and 'player2'";
    return {};
}

std::string_view field(std::span<const std::string_view> fields, int column) {
    return column < 0 || static_cast<std::size_t>(column) >= fields.size()
               ? std::string_view()
               : fields[static_cast<std::size_t>(column)];
}

std::ptrdiff_t columns_kept(const std::string& scope) {
    return scope == "all" ? 0 : 1 + std::count(scope.begin(), scope.end(), '*');
}

// A table of matrices says the same votes again in every scope: the one that keeps most columns
// apart is read.  "" without scopes.
Expected<std::string> scope_to_read(std::string_view text, const std::string& name) {
    PairColumns columns;
    std::vector<std::string> scopes;
    const auto records =
        read_csv(text, name, [&](std::int64_t, std::span<const std::string_view> fields) {
            if (columns.count == 0)
                return read_pair_header(fields, columns);
            const auto scope = field(fields, columns.scope);
            if (columns.scope >= 0 &&
                std::find(scopes.begin(), scopes.end(), scope) == scopes.end())
                scopes.emplace_back(scope);
            return std::string();
        });
    if (!records)
        return tl::unexpected(records.error());
    if (scopes.empty())
        return std::string();
    const auto coarser = [](const auto& a, const auto& b) {
        return columns_kept(a) < columns_kept(b);
    };
    const auto& finest = *std::max_element(scopes.begin(), scopes.end(), coarser);
    for (const auto& other : scopes)
        if (other != finest && columns_kept(other) == columns_kept(finest))
            return tl::unexpected(fmt::format(
                "{}:1: scopes '{}' and '{}' may say the same votes twice; leave the rows of one",
                name, finest, other));
    return finest;
}

class PairReader {
  public:
    explicit PairReader(std::string scope) : scope_(std::move(scope)) {}

    std::string operator()(std::int64_t, std::span<const std::string_view> fields) {
        if (columns_.count == 0) {
            auto wrong = read_pair_header(fields, columns_);
            if (!wrong.empty())
                return wrong;
            counter_.emplace(columns_.factor_names);
            if (columns_.named)
                return {};
        }
        if (fields.size() != columns_.count)
            return fmt::format("{} fields, expected {}", fields.size(), columns_.count);
        if (columns_.scope >= 0 && field(fields, columns_.scope) != scope_)
            return {};
        if (columns_.simulated >= 0 && field(fields, columns_.simulated) == "1")
            counter_->simulated();
        VoteRow row{.observer = text(fields, columns_.observer, "all"),
                    .session = text(fields, columns_.session, "1"),
                    .left = text(fields, columns_.first, ""),
                    .right = text(fields, columns_.second, "")};
        for (const auto factor : columns_.factors)
            row.scene.emplace_back(fields[factor]);
        if (row.left.empty() || row.right.empty() || row.observer.empty())
            return "an empty name, expected a condition or an observer";
        const std::tuple<int, protocols::Choice, std::int64_t> cells[] = {
            {columns_.first_wins, protocols::Choice::Left, columns_.second_wins < 0 ? 1 : 0},
            {columns_.second_wins, protocols::Choice::Right, 0},
            {columns_.ties, protocols::Choice::Tie, 0}};
        for (const auto& [column, chosen, without] : cells) {
            const auto votes = column < 0 ? std::optional(without) : count(field(fields, column));
            if (!votes)
                return fmt::format("'{}', expected a count: a whole number, 0 or more",
                                   field(fields, column));
            if (chosen == protocols::Choice::Tie && columns_.scope >= 0) {
                auto wrong = told_before(row, *votes);
                if (!wrong)
                    continue;
                if (!wrong->empty())
                    return *wrong;
            }
            if (auto wrong = counter_->add(row, chosen, *votes); !wrong.empty())
                return wrong;
        }
        return {};
    }

    Expected<VoteTable> finish(const std::string& name) {
        if (!counter_)
            return tl::unexpected(fmt::format("{}:1: the file is empty", name));
        if (!scope_.empty())
            counter_->remark(fmt::format("the matrices of scope '{}' were read: the other scopes "
                                         "are sums of them",
                                         scope_));
        const bool named =
            columns_.observer >= 0 && (scope_.empty() || scope_.find("observer") != scope_.npos);
        return counter_->finish(name, named);
    }

  private:
    // Scopes leave empty what they pool.
    std::string
    text(std::span<const std::string_view> fields, int column, const char* without) const {
        const auto found = field(fields, column);
        return column < 0 || (found.empty() && !scope_.empty()) ? without : std::string(found);
    }

    // A matrix has each pair in two rows, and the ties in both: nothing when they were counted
    // already, "" when not, or what is wrong.
    std::optional<std::string> told_before(const VoteRow& row, std::int64_t ties) {
        std::vector<std::string> key{row.observer, row.session};
        key.insert(key.end(), row.scene.begin(), row.scene.end());
        key.push_back(std::min(row.left, row.right));
        key.push_back(std::max(row.left, row.right));
        const auto [known, added] = ties_.emplace(std::move(key), ties);
        if (added)
            return "";
        if (known->second == ties)
            return std::nullopt;
        return fmt::format("{} ties of '{}' and '{}', the row the other way round has {}", ties,
                           row.left, row.right, known->second);
    }

    std::string scope_;
    std::map<std::vector<std::string>, std::int64_t> ties_;
    PairColumns columns_;
    std::optional<Counter> counter_;
};

// Rows of counts with an optional row and column of names.
struct NamedRows {
    std::vector<std::string> columns; ///< names, empty without a header
    std::vector<std::string> names;   ///< of rows
    std::vector<std::vector<std::int64_t>> counts;
    std::vector<std::int64_t> lines;
};

Expected<NamedRows> read_named_rows(std::string_view text, const std::string& name) {
    NamedRows rows;
    bool first = true, named = false;
    const auto records =
        read_csv(text, name, [&](std::int64_t line, std::span<const std::string_view> fields) {
            const bool header =
                first && std::any_of(fields.begin(), fields.end(),
                                     [](std::string_view field) { return !count(field); });
            if (std::exchange(first, false) && header) {
                named = true;
                rows.columns.assign(fields.begin() + 1, fields.end());
                return std::string();
            }
            if (named)
                rows.names.emplace_back(fields[0]);
            auto& out = rows.counts.emplace_back();
            rows.lines.push_back(line);
            for (const auto field : fields.subspan(named ? 1 : 0)) {
                const auto votes = count(field);
                if (!votes)
                    return fmt::format("'{}', expected a count: a whole number, 0 or more", field);
                out.push_back(*votes);
            }
            return std::string();
        });
    if (!records)
        return tl::unexpected(records.error());
    if (rows.counts.empty())
        return tl::unexpected(fmt::format("{}:1: no rows of counts", name));
    return rows;
}

std::string name_of(std::size_t place) {
    return fmt::format("{}", place + 1);
}

} // namespace

Expected<VoteTable> read_pair_counts(std::string_view text, const std::string& name) {
    auto scope = scope_to_read(text, name);
    if (!scope)
        return tl::unexpected(scope.error());
    PairReader reader(std::move(*scope));
    const auto records = read_csv(text, name, std::ref(reader));
    if (!records)
        return tl::unexpected(records.error());
    return reader.finish(name);
}

Expected<VoteTable> read_count_matrix(std::string_view text, const std::string& name) {
    auto rows = read_named_rows(text, name);
    if (!rows)
        return tl::unexpected(rows.error());
    const auto t = rows->counts.size();
    if (rows->columns.empty())
        for (std::size_t i = 0; i < t; ++i)
            rows->columns.push_back(name_of(i));
    if (rows->names.empty())
        rows->names = rows->columns;
    Counter counter({});
    for (const auto& condition : rows->columns)
        counter.know(condition);
    for (std::size_t i = 0; i < t; ++i) {
        const auto wrong = [&](const std::string& what) {
            return tl::unexpected(fmt::format("{}:{}: {}", name, rows->lines[i], what));
        };
        if (rows->counts[i].size() != t || rows->columns.size() != t)
            return wrong(fmt::format("{} counts in {} columns, expected a square matrix of {} rows",
                                     rows->counts[i].size(), rows->columns.size(), t));
        if (rows->names[i] != rows->columns[i])
            return wrong(fmt::format("row '{}', expected '{}' as in the header", rows->names[i],
                                     rows->columns[i]));
        for (std::size_t j = 0; j < t; ++j) {
            const VoteRow row{.observer = "all",
                              .session = "1",
                              .left = rows->columns[i],
                              .right = rows->columns[j]};
            if (auto what = counter.add(row, protocols::Choice::Left, rows->counts[i][j]);
                !what.empty())
                return wrong(what);
        }
    }
    return counter.finish(name, false);
}

Expected<VoteTable> read_observer_matrices(std::string_view text, const std::string& name) {
    const auto rows = read_named_rows(text, name);
    if (!rows)
        return tl::unexpected(rows.error());
    const auto elements = rows->counts[0].size();
    const auto n = static_cast<std::size_t>(std::lround(std::sqrt(elements)));
    Counter counter({});
    for (std::size_t i = 0; i < n; ++i)
        counter.know(name_of(i));
    for (std::size_t o = 0; o < rows->counts.size(); ++o) {
        const auto wrong = [&](const std::string& what) {
            return tl::unexpected(fmt::format("{}:{}: {}", name, rows->lines[o], what));
        };
        if (rows->counts[o].size() != elements || n * n != elements || n < 2)
            return wrong(fmt::format("{} counts, expected N times N as in the first row",
                                     rows->counts[o].size()));
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t i = 0; i < n; ++i) {
                const VoteRow row{.observer = rows->names.empty() ? name_of(o) : rows->names[o],
                                  .session = "1",
                                  .left = name_of(i),
                                  .right = name_of(j)};
                if (auto what =
                        counter.add(row, protocols::Choice::Left, rows->counts[o][j * n + i]);
                    !what.empty())
                    return wrong(what);
            }
    }
    return counter.finish(name, true);
}

} // namespace analysis::formats
