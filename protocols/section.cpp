// Reading, and saying what was expected instead.
#include "protocols/section.h"

#include "protocols/spelling.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace protocols {

namespace {

const Table no_table;

/// "a, b, c", and which of them was probably meant.
std::string choices(std::string_view word, const std::vector<std::string>& names) {
    const auto nearest = nearest_name(word, names);
    return fmt::format("{}{}", fmt::join(names, ", "),
                       nearest ? fmt::format(" (did you mean '{}'?)", *nearest) : "");
}

template <class Number>
std::string in_words(std::string_view kind, Range<Number> range) {
    return range.high == std::numeric_limits<Number>::max()
               ? fmt::format("{} of {} or more", kind, range.low)
               : fmt::format("{} from {} to {}", kind, range.low, range.high);
}

bool is_one_line(std::string_view text) {
    const auto is_control = [](char c) { return c >= 0 && c < ' '; };
    return !text.empty() && std::none_of(text.begin(), text.end(), is_control);
}

bool is_file_name(std::string_view id) {
    const auto is_plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
    const auto is_safe = [&](char c) { return is_plain(c) || c == '.' || c == '_' || c == '-'; };
    return !id.empty() && id.size() <= 64 && is_plain(id.front()) &&
           std::all_of(id.begin(), id.end(), is_safe);
}

/// NaN for what is no number.
double as_number(const Node& node) {
    if (const auto* whole = std::get_if<std::int64_t>(&node.value))
        return static_cast<double>(*whole);
    const auto* number = std::get_if<double>(&node.value);
    return number != nullptr ? *number : NAN;
}

} // namespace

void Problems::note(int line, std::string_view what) {
    if (!first_ || line < line_) {
        line_ = line;
        first_ = fmt::format("{}:{}: {}", file_, line, what);
    }
}

Section::Section(const Table& table, int line, std::string name, Problems& problems)
    : table_(&table), line_(line), name_(std::move(name)), problems_(&problems) {}

bool Section::has(std::string_view key) {
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end())
        asked_.emplace_back(key);
    return entry(key) != nullptr;
}

std::string Section::text(std::string_view key, const std::optional<std::string>& fallback) {
    constexpr std::string_view wanted = "text in quotes, on one line";
    const auto* node = find(key, wanted, fallback.has_value());
    if (node == nullptr)
        return fallback.value_or("");
    const auto* text = std::get_if<std::string>(&node->value);
    if (text != nullptr && is_one_line(*text))
        return *text;
    refuse(key, wanted);
    return "";
}

std::string Section::one_of(std::string_view key,
                            const std::vector<std::string>& names,
                            const std::optional<std::string>& fallback) {
    const auto wanted = fmt::format("one of {}", fmt::join(names, ", "));
    const auto* node = find(key, wanted, fallback.has_value());
    if (node == nullptr)
        return fallback.value_or("");
    const auto* word = std::get_if<std::string>(&node->value);
    if (word == nullptr)
        refuse(key, wanted);
    else if (std::find(names.begin(), names.end(), *word) == names.end())
        refuse(key, "one of " + choices(*word, names));
    return word != nullptr ? *word : "";
}

std::vector<std::string> Section::several(std::string_view key) {
    constexpr std::string_view wanted = "a list of texts in quotes, such as [\"one\", \"two\"]";
    std::vector<std::string> texts;
    const auto* node = find(key, wanted, false);
    if (node == nullptr)
        return texts;
    if (const auto* list = std::get_if<List>(&node->value))
        for (const auto& element : *list)
            if (const auto* text = std::get_if<std::string>(&element.value);
                text != nullptr && is_one_line(*text))
                texts.push_back(*text);
    const auto* list = std::get_if<List>(&node->value);
    if (texts.empty() || texts.size() != list->size())
        refuse(key, wanted);
    return texts;
}

std::vector<std::string> Section::several_of(std::string_view key,
                                             const std::vector<std::string>& names) {
    auto texts = several(key);
    for (const auto& text : texts)
        if (std::find(names.begin(), names.end(), text) == names.end())
            note(key, fmt::format("'{}' in the list {} of {}, expected one of {}", text, key, name_,
                                  choices(text, names)));
    return texts;
}

std::string Section::id() {
    auto id = text("id");
    if (!id.empty() && !is_file_name(id))
        refuse("id", "at most 64 of a-z 0-9 . _ - that begin with a letter or digit: files are "
                     "named by it");
    return id;
}

std::int64_t Section::whole(std::string_view key, Range<std::int64_t> range) {
    const auto wanted = in_words("a whole number", range);
    const auto* node = find(key, wanted, false);
    if (node == nullptr)
        return range.low;
    const auto* value = std::get_if<std::int64_t>(&node->value);
    if (value != nullptr && range.has(*value))
        return *value;
    refuse(key, wanted);
    return range.low;
}

void Section::whole(std::string_view key, Range<int> range, int& value) {
    if (has(key))
        value = static_cast<int>(whole(key, Range<std::int64_t>{range.low, range.high}));
}

void Section::number(std::string_view key, Range<double> range, double& value) {
    if (!has(key))
        return;
    value = as_number(entry(key)->node);
    if (!range.has(value))
        refuse(key, in_words("a number", range));
}

std::array<double, 3> Section::rgb(std::string_view key, Range<double> range) {
    const auto wanted = in_words("three numbers [r, g, b] or one for all, each", range);
    std::array<double, 3> channels{};
    channels.fill(range.low);
    const auto* node = find(key, wanted, false);
    if (node == nullptr)
        return channels;
    if (const auto* list = std::get_if<List>(&node->value); list == nullptr)
        channels.fill(as_number(*node));
    else if (list->size() == 3)
        std::transform(list->begin(), list->end(), channels.begin(), as_number);
    else
        channels.fill(NAN);
    if (!std::all_of(channels.begin(), channels.end(), [&](double c) { return range.has(c); }))
        refuse(key, wanted);
    return channels;
}

std::array<double, 3> Section::direction(std::string_view key,
                                         std::optional<std::array<double, 3>> fallback) {
    constexpr std::string_view wanted = "three numbers [x, y, z], not all zero";
    constexpr std::array<double, 3> toward_the_viewer{0, 0, 1};
    const auto* node = find(key, wanted, fallback.has_value());
    if (node == nullptr)
        return fallback.value_or(toward_the_viewer);
    const auto* list = std::get_if<List>(&node->value);
    if (list != nullptr && list->size() == 3) {
        std::array<double, 3> direction{};
        std::transform(list->begin(), list->end(), direction.begin(), as_number);
        const double length = std::hypot(direction[0], direction[1], direction[2]);
        if (length > 0 && std::isfinite(length)) {
            for (auto& component : direction)
                component /= length;
            return direction;
        }
    }
    refuse(key, wanted);
    return toward_the_viewer;
}

std::array<double, 3>
Section::triple(std::string_view key, Range<double> range, std::array<double, 3> fallback) {
    if (!has(key))
        return fallback;
    if (const auto* list = std::get_if<List>(&entry(key)->node.value);
        list != nullptr && list->size() == 3) {
        std::array<double, 3> values{};
        std::transform(list->begin(), list->end(), values.begin(), as_number);
        if (std::all_of(values.begin(), values.end(), [&](double v) { return range.has(v); }))
            return values;
    }
    refuse(key, fmt::format("three numbers [x, y, z], each {}", in_words("a number", range)));
    return fallback;
}

std::vector<Entry> Section::rest() {
    std::vector<Entry> entries;
    for (const auto& each : *table_)
        if (std::find(asked_.begin(), asked_.end(), each.key) == asked_.end())
            entries.push_back(each);
    for (const auto& each : entries)
        asked_.push_back(each.key);
    return entries;
}

Section Section::table(std::string_view key, bool required) {
    const auto name = fmt::format("[{}]", key);
    const auto wanted = "the table " + name;
    if (const auto* node = find(key, wanted, !required)) {
        if (const auto* table = std::get_if<Table>(&node->value))
            return {*table, node->line, name, *problems_};
        refuse(key, wanted);
    }
    // Nothing that such a table lacks is nearer to the beginning than its own absence.
    return {no_table, std::numeric_limits<int>::max(), name, *problems_};
}

std::vector<Section> Section::tables(std::string_view key) {
    const auto name = fmt::format("[[{}]]", key);
    const auto wanted = name + " in double brackets above each";
    std::vector<Section> sections;
    const auto* node = find(key, wanted, true);
    if (node == nullptr)
        return sections;
    const auto* list = std::get_if<List>(&node->value);
    if (list == nullptr) {
        refuse(key, wanted);
        return sections;
    }
    for (const auto& element : *list)
        if (const auto* table = std::get_if<Table>(&element.value))
            sections.emplace_back(*table, element.line, name, *problems_);
        else
            refuse(key, wanted);
    return sections;
}

void Section::expect_nothing_else() const {
    for (const auto& [key, line, node] : *table_)
        if (std::find(asked_.begin(), asked_.end(), key) == asked_.end())
            problems_->note(line, fmt::format("unknown key '{}' in {}, expected one of {}", key,
                                              name_, choices(key, asked_)));
}

void Section::refuse(std::string_view key, std::string_view wanted) const {
    note(key,
         fmt::format("{} in {} is {}, expected {}", key, name_, shown(entry(key)->node), wanted));
}

void Section::note(std::string_view key, std::string_view what) const {
    const auto* found = entry(key);
    problems_->note(found != nullptr ? found->line : line_, what);
}

const Entry* Section::entry(std::string_view key) const {
    const auto found = std::find_if(table_->begin(), table_->end(),
                                    [&](const Entry& each) { return each.key == key; });
    return found != table_->end() ? &*found : nullptr;
}

const Node* Section::find(std::string_view key, std::string_view wanted, bool optional) {
    if (has(key))
        return &entry(key)->node;
    if (!optional)
        note_missing(key, wanted);
    return nullptr;
}

void Section::note_missing(std::string_view key, std::string_view wanted) const {
    std::vector<std::string> others;
    for (const auto& each : *table_)
        if (std::find(asked_.begin(), asked_.end(), each.key) == asked_.end())
            others.push_back(each.key);
    if (const auto misspelt = nearest_name(key, others))
        note(*misspelt,
             fmt::format("unknown key '{}' in {}, did you mean '{}'?", *misspelt, name_, key));
    else
        problems_->note(line_, fmt::format("{} has no '{}', expected {}", name_, key, wanted));
}

} // namespace protocols
