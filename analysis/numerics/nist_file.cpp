// The data follow the last line that starts with "Data:"; an earlier one describes the factor.
#include "analysis/numerics/nist_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace analysis::numerics {
namespace {

struct Line {
    int number = 0;
    std::vector<std::string_view> words;
};

std::vector<std::string_view> words_of(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    std::vector<std::string_view> words;
    for (std::size_t at = line.find_first_not_of(blanks); at != line.npos;
         at = line.find_first_not_of(blanks, at)) {
        const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

std::vector<Line> lines_of(std::string_view text) {
    std::vector<Line> lines;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (auto words = words_of(text.substr(0, end)); !words.empty())
            lines.push_back({number, std::move(words)});
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

// The last `fields.size()` words of the line, as numbers.
bool read_last_words(const Line& line, std::initializer_list<double*> fields) {
    if (line.words.size() < fields.size())
        return false;
    auto word = line.words.end() - static_cast<std::ptrdiff_t>(fields.size());
    for (double* field : fields) {
        const auto [end, error] =
            std::from_chars(word->data(), word->data() + word->size(), *field);
        if (error != std::errc() || end != word->data() + word->size())
            return false;
        ++word;
    }
    return true;
}

bool read_certified(const Line& line, NistCertified& certified, int& found) {
    const auto& words = line.words;
    const bool squared = words.size() > 1 && words[0] == "Certified" && words[1] == "R-Squared";
    const bool deviation = words.size() > 1 && words[0] == "Standard" && words[1] == "Deviation";
    found += words[0] == "Between" || words[0] == "Within" || squared || deviation;
    if (words[0] == "Between")
        return read_last_words(line, {&certified.df_between, &certified.ss_between,
                                      &certified.ms_between, &certified.f});
    if (words[0] == "Within")
        return read_last_words(line,
                               {&certified.df_within, &certified.ss_within, &certified.ms_within});
    if (squared)
        return read_last_words(line, {&certified.r_squared});
    return !deviation || read_last_words(line, {&certified.residual_sd});
}

void add_value(NistOneWay& set, std::string_view label, Decimal value) {
    const auto known = std::find(set.labels.rbegin(), set.labels.rend(), label);
    if (known == set.labels.rend()) {
        set.labels.emplace_back(label);
        set.groups.emplace_back();
        set.groups.back().push_back(value);
        return;
    }
    set.groups[static_cast<std::size_t>(set.labels.rend() - known - 1)].push_back(value);
}

} // namespace

protocols::Expected<NistOneWay> read_nist_one_way(std::string_view text, std::string_view name) {
    const auto wrong = [&](int line, const std::string& what) {
        return tl::make_unexpected(fmt::format("{}:{}: {}", name, line, what));
    };
    const auto lines = lines_of(text);
    const auto data = std::find_if(lines.rbegin(), lines.rend(),
                                   [](const Line& line) { return line.words[0] == "Data:"; });
    if (data == lines.rend())
        return wrong(1, "no line starts with 'Data:', expected NIST's text form of an ANOVA set");
    NistOneWay set;
    int certified_lines = 0;
    for (auto line = lines.begin(); line != data.base(); ++line)
        if (!read_certified(*line, set.certified, certified_lines))
            return wrong(line->number, fmt::format("'{}' line without its certified numbers",
                                                   fmt::join(line->words, " ")));
    if (certified_lines != 4)
        return wrong(data->number, fmt::format("{} certified lines before the data, expected 4: "
                                               "Between, Within, R-Squared, Standard Deviation",
                                               certified_lines));
    const bool headed = data->words.size() == 3;
    set.factor_name = headed ? data->words[1] : "group";
    set.response_name = headed ? data->words[2] : "value";
    for (auto line = data.base(); line != lines.end(); ++line) {
        if (line->words.size() != 2)
            return wrong(line->number,
                         fmt::format("'{}' has {} columns, expected group and value",
                                     fmt::join(line->words, " "), line->words.size()));
        const auto value = parse_decimal(line->words[1]);
        if (!value)
            return wrong(line->number, value.error());
        add_value(set, line->words[0], *value);
    }
    if (set.groups.size() < 2)
        return wrong(data->number,
                     fmt::format("{} groups of data, expected at least 2", set.groups.size()));
    return set;
}

} // namespace analysis::numerics
