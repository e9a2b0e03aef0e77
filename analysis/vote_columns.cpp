#include "analysis/vote_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace analysis {

namespace {

struct KnownColumn {
    std::string_view name;
    int VoteColumns::*place;
};

constexpr KnownColumn known_columns[] = {{"study", &VoteColumns::study},
                                         {"study_id", &VoteColumns::study},
                                         {"observer", &VoteColumns::observer},
                                         {"observer_id", &VoteColumns::observer},
                                         {"participant_id", &VoteColumns::observer},
                                         {"participant", &VoteColumns::observer},
                                         {"subject", &VoteColumns::observer},
                                         {"session", &VoteColumns::session},
                                         {"session_id", &VoteColumns::session},
                                         {"session_index", &VoteColumns::session},
                                         {"trial", &VoteColumns::trial},
                                         {"trial_shown", &VoteColumns::trial},
                                         {"left", &VoteColumns::left},
                                         {"left_method", &VoteColumns::left},
                                         {"condition_A", &VoteColumns::left},
                                         {"right", &VoteColumns::right},
                                         {"right_method", &VoteColumns::right},
                                         {"condition_B", &VoteColumns::right},
                                         {"rt_ms", &VoteColumns::milliseconds},
                                         {"response_time", &VoteColumns::seconds},
                                         {"time_spent", &VoteColumns::seconds},
                                         {"phase", &VoteColumns::phase},
                                         {"counted", &VoteColumns::counted},
                                         {"simulated", &VoteColumns::simulated}};

struct KnownAnswer {
    std::string_view name;
    AnswerForm form;
};

constexpr KnownAnswer known_answers[] = {
    {"chosen", AnswerForm::Side},           {"choice", AnswerForm::Side},
    {"response", AnswerForm::Side},         {"is_A_selected", AnswerForm::FirstChosen},
    {"selection", AnswerForm::FirstSecond}, {"selected", AnswerForm::Name}};

// Times of day are known, but say nothing about the vote.
constexpr std::string_view passed_over[] = {"onset_utc", "utc"};

// Vote rows with everything a session knows; scenes are made of these two columns only.
constexpr std::string_view sessions_own_column = "left_method";
constexpr std::string_view sessions_own_factors[] = {"scene", "variant"};

bool contains(std::span<const std::string_view> names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// "" when it was one, with its place kept.
std::optional<std::string>
place_known(std::string_view name, int at, VoteColumns& columns, std::string& answer) {
    for (const auto& known : known_answers)
        if (known.name == name) {
            if (columns.answer >= 0)
                return fmt::format("both '{}' and '{}', expected one column with the answer",
                                   answer, name);
            answer = name;
            columns.answer = at;
            columns.form = known.form;
            return "";
        }
    for (const auto& known : known_columns)
        if (known.name == name) {
            auto& place = columns.*known.place;
            if (place >= 0)
                return fmt::format("column '{}' says again what another does, expected one", name);
            place = at;
            columns.sides_known = columns.sides_known && !name.starts_with("condition_");
            return "";
        }
    if (contains(passed_over, name))
        return "";
    return std::nullopt;
}

std::string missing(const VoteColumns& columns) {
    const std::pair<const char*, int> needed[] = {{"observer", columns.observer},
                                                  {"left", columns.left},
                                                  {"right", columns.right},
                                                  {"chosen", columns.answer}};
    for (const auto& [word, place] : needed)
        if (place < 0)
            return fmt::format("no column '{}', expected a header row with observer, left, right "
                               "and chosen (or choice)",
                               word);
    return {};
}

} // namespace

std::string read_vote_columns(std::span<const std::string_view> header, VoteColumns& columns) {
    columns.count = header.size();
    std::vector<std::size_t> others;
    std::string answer;
    for (std::size_t i = 0; i < header.size(); ++i) {
        if (contains(header.first(i), header[i]))
            return fmt::format("column '{}' stands twice, expected each name once", header[i]);
        const auto wrong = place_known(header[i], static_cast<int>(i), columns, answer);
        if (!wrong)
            others.push_back(i);
        else if (!wrong->empty())
            return *wrong;
    }
    if (auto what = missing(columns); !what.empty())
        return what;
    const bool sessions_own = contains(header, sessions_own_column);
    for (const auto i : others) {
        const bool factor = sessions_own ? contains(sessions_own_factors, header[i])
                                         : static_cast<int>(i) < columns.right;
        if (factor) {
            columns.factors.push_back(i);
            columns.factor_names.emplace_back(header[i]);
        } else {
            columns.left_out.emplace_back(header[i]);
        }
    }
    return {};
}

} // namespace analysis
