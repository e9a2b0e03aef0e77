#include "analysis/formats/wide_files.h"

#include "analysis/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

namespace analysis::formats {

namespace {

struct Pair {
    std::size_t column = 0;
    std::string first, second;
};

std::optional<Pair> pair_of(std::string_view name) {
    if (const auto colon = name.find(':');
        colon != name.npos && colon > 0 && colon + 1 < name.size())
        return Pair{0, std::string(name.substr(0, colon)), std::string(name.substr(colon + 1))};
    const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    if (name.size() == 3 && name[0] == 'V' && digit(name[1]) && digit(name[2]))
        return Pair{0, std::string(1, name[1]), std::string(1, name[2])};
    return std::nullopt;
}

bool is_observer(std::string_view name) {
    return name == "observer" || name == "subject" || name == "participant" ||
           name == "participant_id";
}

// What a column holds: V12 and 1:2 are the same pair.
std::string meaning_of(std::string_view name) {
    if (const auto pair = pair_of(name))
        return fmt::format("{}:{}", pair->first, pair->second);
    return is_observer(name) ? "observer" : std::string(name);
}

// Of two columns with one meaning, either both would count or one would be lost.
std::string doubled_column(std::span<const std::string_view> header) {
    std::map<std::string, std::string_view> seen;
    for (const auto name : header)
        if (const auto [before, added] = seen.emplace(meaning_of(name), name); !added)
            return fmt::format("column '{}' says the same as '{}' before it, expected each pair "
                               "and each name once",
                               name, before->second);
    return {};
}

class WideReader {
  public:
    explicit WideReader(SecondChosen second) : second_(second) {}

    std::string operator()(std::int64_t, std::span<const std::string_view> fields) {
        if (width_ == 0)
            return header(fields);
        if (fields.size() != width_)
            return fmt::format("{} fields, expected {} as in the header", fields.size(), width_);
        ++row_;
        VoteRow row;
        row.observer = observer_ < 0 ? fmt::format("{}", row_) : at(fields, observer_);
        row.session = session_ < 0 ? "1" : at(fields, session_);
        for (const auto factor : factors_)
            row.scene.emplace_back(fields[factor]);
        if (row.observer.empty())
            return "an empty observer, expected a name";
        table_->simulated = table_->simulated || (simulated_ >= 0 && at(fields, simulated_) == "1");
        for (const auto& pair : pairs_)
            if (auto wrong = answer(row, pair, fields[pair.column]); !wrong.empty())
                return wrong;
        return {};
    }

    Expected<VoteTable> finish(const std::string& name) {
        if (!table_ || table_->size() == 0)
            return tl::unexpected(fmt::format("{}:1: no votes", name));
        table_->notes.emplace_back("the file does not say which condition was on the left: what is "
                                   "said of the left side is of the one named first");
        if (not_asked_ > 0)
            table_->notes.push_back(fmt::format("{} cells are empty: not asked", not_asked_));
        return std::move(*table_);
    }

  private:
    static std::string at(std::span<const std::string_view> fields, int column) {
        return std::string(fields[static_cast<std::size_t>(column)]);
    }

    std::string header(std::span<const std::string_view> fields) {
        width_ = fields.size();
        std::vector<std::string> names;
        if (auto wrong = doubled_column(fields); !wrong.empty())
            return wrong;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (auto pair = pair_of(fields[i])) {
                if (pair->first == pair->second)
                    return fmt::format("column '{}' is a condition against itself, expected two "
                                       "conditions",
                                       fields[i]);
                pair->column = i;
                pairs_.push_back(*pair);
            } else if (is_observer(fields[i])) {
                observer_ = static_cast<int>(i);
            } else if (fields[i] == "session") {
                session_ = static_cast<int>(i);
            } else if (fields[i] == "simulated") {
                simulated_ = static_cast<int>(i);
            } else {
                factors_.push_back(i);
                names.emplace_back(fields[i]);
            }
        }
        if (pairs_.empty())
            return "no column of a pair, expected names such as A:B";
        table_ = empty_vote_table(names);
        return {};
    }

    std::string answer(VoteRow& row, const Pair& pair, std::string_view text) {
        row.left = pair.first;
        row.right = pair.second;
        const bool minus = second_ == SecondChosen::MinusOne;
        if (text.empty() || text == "NA") {
            ++not_asked_;
            return {};
        }
        if (text == "1")
            row.chosen = protocols::Choice::Left;
        else if (text == (minus ? "-1" : "0"))
            row.chosen = protocols::Choice::Right;
        else if (minus && text == "0")
            row.chosen = protocols::Choice::Tie;
        else
            return fmt::format("{}:{} is '{}', expected {}", pair.first, pair.second, text,
                               minus ? "1, -1, or 0 for undecided" : "1 or 0");
        append_vote(*table_, row);
        return {};
    }

    SecondChosen second_;
    std::size_t width_ = 0;
    std::int64_t row_ = 0, not_asked_ = 0;
    int observer_ = -1, session_ = -1, simulated_ = -1;
    std::vector<Pair> pairs_;
    std::vector<std::size_t> factors_;
    std::optional<VoteTable> table_;
};

} // namespace

bool has_pair_columns(std::span<const std::string_view> header) {
    return std::any_of(header.begin(), header.end(),
                       [](std::string_view name) { return pair_of(name).has_value(); });
}

Expected<VoteTable>
read_wide_votes(std::string_view text, const std::string& name, SecondChosen second) {
    WideReader reader(second);
    const auto records = read_csv(text, name, std::ref(reader));
    if (!records)
        return tl::unexpected(records.error());
    return reader.finish(name);
}

} // namespace analysis::formats
