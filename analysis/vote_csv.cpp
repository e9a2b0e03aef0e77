#include "analysis/vote_csv.h"

#include "analysis/csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace analysis {

namespace {

// Where each known column stands; -1 when the file has none.
struct Columns {
    int study = -1, observer = -1, session = -1, trial = -1, left = -1, right = -1, chosen = -1,
        response_ms = -1, onset = -1, phase = -1, simulated = -1;
    std::vector<std::size_t> factors;
    std::vector<std::string> factor_names;
    std::vector<std::string> left_out;
    std::size_t count = 0;
};

int* known_column(Columns& columns, std::string_view name) {
    const std::pair<std::string_view, int*> known[] = {
        {"study", &columns.study},       {"observer", &columns.observer},
        {"session", &columns.session},   {"trial", &columns.trial},
        {"left", &columns.left},         {"right", &columns.right},
        {"chosen", &columns.chosen},     {"choice", &columns.chosen},
        {"rt_ms", &columns.response_ms}, {"onset_utc", &columns.onset},
        {"phase", &columns.phase},       {"simulated", &columns.simulated}};
    for (const auto& [word, place] : known)
        if (word == name)
            return place;
    return nullptr;
}

std::string missing_column(const Columns& columns) {
    const std::pair<const char*, int> needed[] = {{"observer", columns.observer},
                                                  {"left", columns.left},
                                                  {"right", columns.right},
                                                  {"chosen", columns.chosen}};
    for (const auto& [word, place] : needed)
        if (place < 0)
            return fmt::format("no column '{}', expected a header row with observer, left, right "
                               "and chosen (or choice)",
                               word);
    return {};
}

std::string read_header(std::span<const std::string_view> fields, Columns& columns) {
    columns.count = fields.size();
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (std::find(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(i), fields[i]) !=
            fields.begin() + static_cast<std::ptrdiff_t>(i))
            return fmt::format("column '{}' stands twice, expected each name once", fields[i]);
        int* place = known_column(columns, fields[i]);
        if (place == nullptr)
            others.push_back(i);
        else if (*place >= 0)
            return "both 'chosen' and 'choice', expected one column with the answer";
        else
            *place = static_cast<int>(i);
    }
    if (auto missing = missing_column(columns); !missing.empty())
        return missing;
    for (const auto i : others) {
        if (static_cast<int>(i) < columns.right) {
            columns.factors.push_back(i);
            columns.factor_names.emplace_back(fields[i]);
        } else {
            columns.left_out.emplace_back(fields[i]);
        }
    }
    return {};
}

std::optional<protocols::Choice> choice(std::string_view text) {
    if (text == "left")
        return protocols::Choice::Left;
    if (text == "right")
        return protocols::Choice::Right;
    if (text == "tie")
        return protocols::Choice::Tie;
    return std::nullopt;
}

// Digits only; times with a fraction are rounded down to the millisecond the table keeps.
std::optional<std::int32_t> whole_number(std::string_view text) {
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = error == std::errc{} && end == text.data() + text.size() && value >= 0;
    return good ? std::optional(value) : std::nullopt;
}

class VoteReader {
  public:
    explicit VoteReader(VoteTable& table) : table_(table) {}

    std::string operator()(std::int64_t line, std::span<const std::string_view> fields) {
        if (columns_.count == 0) {
            auto wrong = read_header(fields, columns_);
            if (wrong.empty())
                table_ = empty_vote_table(columns_.factor_names);
            return wrong;
        }
        if (fields.size() != columns_.count)
            return fmt::format("{} fields, expected {} as in the header", fields.size(),
                               columns_.count);
        if (columns_.phase >= 0 && at(fields, columns_.phase) != "main")
            return skip(at(fields, columns_.phase));
        auto wrong = about_the_file(fields);
        if (wrong.empty())
            wrong = vote(fields);
        lines_.push_back(line);
        return wrong;
    }

    bool has_header() const { return columns_.count > 0; }

    const Columns& columns() const { return columns_; }

    std::int64_t line(std::int64_t vote) const { return lines_[static_cast<std::size_t>(vote)]; }

  private:
    static std::string_view at(std::span<const std::string_view> fields, int column) {
        return fields[static_cast<std::size_t>(column)];
    }

    std::string skip(std::string_view phase) {
        if (phase != "training" && phase != "warmup")
            return fmt::format("phase '{}', expected training, warmup or main", phase);
        ++table_.skipped_not_main;
        return {};
    }

    std::string about_the_file(std::span<const std::string_view> fields) {
        if (columns_.study >= 0) {
            const auto study = at(fields, columns_.study);
            if (table_.size() > 0 && study != table_.study)
                return fmt::format("study '{}' after '{}', expected one study per file", study,
                                   table_.study);
            table_.study = study;
        }
        if (columns_.simulated >= 0) {
            const auto simulated = at(fields, columns_.simulated);
            if (simulated == "1" || simulated == "true")
                table_.simulated = true;
            else if (simulated != "0" && simulated != "false")
                return fmt::format("simulated is '{}', expected 0, 1, false or true", simulated);
        }
        return {};
    }

    std::string vote(std::span<const std::string_view> fields) {
        const auto left = at(fields, columns_.left), right = at(fields, columns_.right);
        if (at(fields, columns_.observer).empty() || left.empty() || right.empty())
            return "an empty observer, left or right, expected a name";
        if (left == right)
            return fmt::format("left and right are both '{}', expected two different conditions",
                               left);
        const auto chosen = choice(at(fields, columns_.chosen));
        if (!chosen)
            return fmt::format("answer '{}', expected left, right or tie",
                               at(fields, columns_.chosen));
        table_.chosen.push_back(*chosen);
        table_.observer.push_back(table_.observers.code(at(fields, columns_.observer)));
        table_.session.push_back(
            table_.sessions.code(columns_.session < 0 ? "1" : at(fields, columns_.session)));
        for (std::size_t f = 0; f < columns_.factors.size(); ++f)
            table_.factor[f].push_back(table_.factors[f].code(fields[columns_.factors[f]]));
        table_.left.push_back(static_cast<std::uint16_t>(table_.conditions.code(left)));
        table_.right.push_back(static_cast<std::uint16_t>(table_.conditions.code(right)));
        if (table_.conditions.size() > 65535)
            return "more than 65535 conditions";
        auto wrong = number(fields, columns_.trial, "trial", 0, table_.trial);
        return wrong.empty() ? number(fields, columns_.response_ms, "rt_ms", -1, table_.response_ms)
                             : wrong;
    }

    static std::string number(std::span<const std::string_view> fields,
                              int column,
                              std::string_view name,
                              std::int32_t absent,
                              std::vector<std::int32_t>& out) {
        out.push_back(absent);
        if (column < 0 || at(fields, column).empty())
            return {};
        const auto value = whole_number(at(fields, column));
        if (!value)
            return fmt::format("{} is '{}', expected a whole number, 0 or more", name,
                               at(fields, column));
        out.back() = *value;
        return {};
    }

    VoteTable& table_;
    Columns columns_;
    std::vector<std::int64_t> lines_;
};

} // namespace

Expected<VoteTable>
read_votes_csv(std::string_view text, const std::string& name, Repeats repeats) {
    VoteTable table;
    VoteReader reader(table);
    const auto records = read_csv(text, name, std::ref(reader));
    if (!records)
        return tl::unexpected(records.error());
    if (!reader.has_header())
        return tl::unexpected(fmt::format(
            "{}:1: the file is empty, expected a header row with observer, left, right and chosen",
            name));
    if (table.size() == 0)
        return tl::unexpected(
            fmt::format("{}:1: no votes below the header, expected one per row", name));
    if (repeats == Repeats::Refuse)
        if (const auto [first, second] = first_repeat(table); second >= 0)
            return tl::unexpected(fmt::format(
                "{}:{}: {} answered this question already on line {}, expected one vote per "
                "observer, session, scene and pair",
                name, reader.line(second),
                table.observers.name(table.observer[static_cast<std::size_t>(second)]),
                reader.line(first)));
    if (!reader.columns().left_out.empty())
        table.notes.push_back(
            fmt::format("columns not read: {}", fmt::join(reader.columns().left_out, ", ")));
    return table;
}

} // namespace analysis
