#include "analysis/vote_csv.h"

#include "analysis/csv.h"
#include "analysis/vote_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>

namespace analysis {

namespace {

// What a row's answer means: a choice, none at all (passed over), or what is wrong with it.
struct Answer {
    std::optional<protocols::Choice> chosen;
    bool not_sure = false;
    std::string wrong;
};

Answer side_answer(std::string_view text) {
    if (text == "left")
        return {protocols::Choice::Left, false, {}};
    if (text == "right")
        return {protocols::Choice::Right, false, {}};
    if (text == "tie")
        return {protocols::Choice::Tie, false, {}};
    if (text == "not_sure" || text == "not sure" || text == "undecided")
        return {protocols::Choice::Tie, true, {}};
    if (text == "none" || text == "n/a")
        return {};
    return {{}, false, fmt::format("answer '{}', expected left, right or tie", text)};
}

// `first` and `second` are the words for the two, "0.5" the word for neither.
Answer coded_answer(std::string_view text, std::string_view first, std::string_view second) {
    if (text == first)
        return {protocols::Choice::Left, false, {}};
    if (text == second)
        return {protocols::Choice::Right, false, {}};
    if (text == "0.5")
        return {protocols::Choice::Tie, false, {}};
    if (text == "n/a" || text == "NA")
        return {};
    return {{},
            false,
            fmt::format("answer '{}', expected {}, {} or 0.5 for a tie", text, first, second)};
}

Answer named_answer(std::string_view text, std::string_view left, std::string_view right) {
    if (text == left)
        return {protocols::Choice::Left, false, {}};
    if (text == right)
        return {protocols::Choice::Right, false, {}};
    return {{}, false, fmt::format("answer '{}', expected {} or {}", text, left, right)};
}

Answer
answer_of(AnswerForm form, std::string_view text, std::string_view left, std::string_view right) {
    switch (form) {
    case AnswerForm::Side:
        return side_answer(text);
    case AnswerForm::FirstChosen:
        return coded_answer(text, "1", "0");
    case AnswerForm::FirstSecond:
        return coded_answer(text, "1", "2");
    case AnswerForm::Name:
        return named_answer(text, left, right);
    }
    return {};
}

std::optional<std::int32_t> whole_number(std::string_view text) {
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = error == std::errc{} && end == text.data() + text.size() && value >= 0;
    return good ? std::optional(value) : std::nullopt;
}

// Seconds with decimals, to the nearest millisecond.
std::optional<std::int32_t> seconds(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good =
        error == std::errc{} && end == text.data() + text.size() && value >= 0 && value < 2e6;
    return good ? std::optional(static_cast<std::int32_t>(std::lround(1000 * value)))
                : std::nullopt;
}

class VoteReader {
  public:
    VoteReader(VoteTable& table, std::string_view text)
        : table_(table),
          rows_(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'))) {}

    std::string operator()(std::int64_t line, std::span<const std::string_view> fields) {
        if (columns_.count == 0) {
            auto wrong = read_vote_columns(fields, columns_);
            if (wrong.empty()) {
                table_ = empty_vote_table(columns_.factor_names);
                reserve_votes(table_, rows_);
                lines_.reserve(rows_);
            }
            return wrong;
        }
        if (fields.size() != columns_.count)
            return fmt::format("{} fields, expected {} as in the header", fields.size(),
                               columns_.count);
        if (columns_.phase >= 0 && at(fields, columns_.phase) != "main")
            return skip(at(fields, columns_.phase));
        if (columns_.counted >= 0 && at(fields, columns_.counted) == "0") {
            ++not_counted_;
            return {};
        }
        auto wrong = about_the_file(fields);
        const auto before = table_.size();
        if (wrong.empty())
            wrong = vote(fields);
        if (table_.size() > before)
            lines_.push_back(static_cast<std::uint32_t>(line));
        return wrong;
    }

    bool has_header() const { return columns_.count > 0; }

    // What was done with the file that its reader should know.
    std::vector<std::string> notes() const {
        std::vector<std::string> said;
        if (!columns_.left_out.empty())
            said.push_back(fmt::format("columns not read: {}", fmt::join(columns_.left_out, ", ")));
        if (not_counted_ > 0)
            said.push_back(
                fmt::format("{} rows marked as not counted were passed over", not_counted_));
        if (unanswered_ > 0)
            said.push_back(
                fmt::format("{} questions without an answer were passed over", unanswered_));
        if (not_sure_ > 0)
            said.push_back(
                fmt::format("{} answers were \"not sure\": they count as ties", not_sure_));
        if (!columns_.sides_known)
            said.push_back("the file does not say which condition was on the left: what is said "
                           "of the left side is of the one named first");
        return said;
    }

    std::int64_t line(std::int64_t vote) const { return lines_[static_cast<std::size_t>(vote)]; }

  private:
    static std::string_view at(std::span<const std::string_view> fields, int column) {
        return fields[static_cast<std::size_t>(column)];
    }

    std::string skip(std::string_view phase) {
        constexpr std::string_view known[] = {"training", "warmup", "repeat",
                                              "break",    "page",   "event"};
        if (std::find(std::begin(known), std::end(known), phase) == std::end(known))
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
        const auto answer = answer_of(columns_.form, at(fields, columns_.answer), left, right);
        if (!answer.wrong.empty())
            return answer.wrong;
        if (!answer.chosen) {
            ++unanswered_;
            return {};
        }
        not_sure_ += answer.not_sure ? 1 : 0;
        table_.chosen.push_back(*answer.chosen);
        table_.observer.push_back(table_.observers.code(at(fields, columns_.observer)));
        table_.session.push_back(
            table_.sessions.code(columns_.session < 0 ? "1" : at(fields, columns_.session)));
        for (std::size_t f = 0; f < columns_.factors.size(); ++f)
            table_.factor[f].push_back(table_.factors[f].code(fields[columns_.factors[f]]));
        table_.left.push_back(static_cast<std::uint16_t>(table_.conditions.code(left)));
        table_.right.push_back(static_cast<std::uint16_t>(table_.conditions.code(right)));
        if (table_.conditions.size() > 65535)
            return "more than 65535 conditions";
        auto wrong = number(fields, columns_.trial, "trial", 0, table_.trial, whole_number);
        if (!wrong.empty())
            return wrong;
        if (columns_.milliseconds < 0 && columns_.seconds >= 0)
            return number(fields, columns_.seconds, "the time", -1, table_.response_ms, seconds);
        return number(fields, columns_.milliseconds, "rt_ms", -1, table_.response_ms, whole_number);
    }

    static std::string number(std::span<const std::string_view> fields,
                              int column,
                              std::string_view name,
                              std::int32_t absent,
                              std::vector<std::int32_t>& out,
                              std::optional<std::int32_t> (*read)(std::string_view)) {
        out.push_back(absent);
        if (column < 0 || at(fields, column).empty() || at(fields, column) == "n/a")
            return {};
        const auto value = read(at(fields, column));
        if (!value)
            return fmt::format("{} is '{}', expected a {}number, 0 or more", name,
                               at(fields, column), read == whole_number ? "whole " : "");
        out.back() = *value;
        return {};
    }

    VoteTable& table_;
    VoteColumns columns_;
    std::size_t rows_; ///< at most so many follow
    std::vector<std::uint32_t> lines_;
    std::int64_t not_counted_ = 0, unanswered_ = 0, not_sure_ = 0;
};

// A study without variants has one, with an empty name: such a column makes no scene.
void leave_out_empty_factors(VoteTable& table) {
    for (std::size_t f = table.factors.size(); f-- > 0;)
        if (table.factors[f].size() == 1 && table.factors[f].name(0).empty()) {
            const auto at = static_cast<std::ptrdiff_t>(f);
            table.factors.erase(table.factors.begin() + at);
            table.factor.erase(table.factor.begin() + at);
            table.factor_names.erase(table.factor_names.begin() + at);
        }
}

} // namespace

Expected<VoteTable>
read_votes_csv(std::string_view text, const std::string& name, Repeats repeats) {
    VoteTable table;
    VoteReader reader(table, text);
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
    table.notes = reader.notes();
    leave_out_empty_factors(table);
    return table;
}

} // namespace analysis
