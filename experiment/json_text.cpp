// The library parses and says where it stopped; why is said in words of ours.
#include "experiment/json_text.h"

#include "analysis/utf8.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace experiment {

namespace {

using Object = std::vector<JsonMember>;
using List = std::vector<JsonValue>;

constexpr std::size_t most_levels = 64; // values are copied and dropped level by level
constexpr int number_too_large = 406;   // nlohmann's number of that complaint

/// As a message may show it: on one line, short.
std::string shown_text(std::string_view text) {
    constexpr std::size_t longest = 32;
    std::string shown;
    for (const char c : text.substr(0, longest))
        shown += c >= ' ' && c <= '~' ? c : '?';
    return shown + (text.size() > longest ? "..." : "");
}

std::string shown(const JsonValue& value) {
    struct Words {
        std::string operator()(std::monostate) const { return "null"; }

        std::string operator()(bool truth) const { return truth ? "true" : "false"; }

        std::string operator()(std::uint64_t number) const { return fmt::format("{}", number); }

        std::string operator()(std::int64_t number) const { return fmt::format("{}", number); }

        std::string operator()(double number) const { return fmt::format("{}", number); }

        std::string operator()(const std::string& text) const {
            return fmt::format("\"{}\"", shown_text(text));
        }

        std::string operator()(const List&) const { return "a list"; }

        std::string operator()(const Object&) const { return "an object"; }
    };

    return std::visit(Words{}, value.value);
}

/// Goes through the text and lets others see how far.
class Reading {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Reading(const char* at, const char** seen) : at_(at), seen_(seen) {}

    reference operator*() const { return *at_; }

    Reading& operator++() {
        *seen_ = ++at_;
        return *this;
    }

    bool operator==(const Reading& other) const { return at_ == other.at_; }

  private:
    const char* at_;
    const char** seen_;
};

/// Builds the value from the library's events.  The names of most members are the library's.
class Builder {
  public:
    explicit Builder(std::string_view text) : text_(text), seen_(text.data()) {}

    Reading begin() { return {text_.data(), &seen_}; }

    Reading end() { return {text_.data() + text_.size(), &seen_}; }

    /// "<line>: <what>"; empty when all went well.
    std::string complaint;
    JsonValue whole;

    bool null() { return take(std::monostate{}); }

    bool boolean(bool truth) { return take(truth); }

    bool number_integer(std::int64_t number) {
        return number < 0 ? take(number) : take(static_cast<std::uint64_t>(number)); // -0 is 0
    }

    bool number_unsigned(std::uint64_t number) { return take(number); }

    bool number_float(double number, const std::string&) { return take(number); }

    bool string(std::string& text) { return take(std::move(text)); }

    bool binary(nlohmann::json::binary_t&) { return false; } // no text has any

    bool start_object(std::size_t) { return open(Object{}); }

    bool start_array(std::size_t) { return open(List{}); }

    bool end_object() { return close(); }

    bool end_array() { return close(); }

    bool key(std::string& name) {
        auto& level = levels_.back();
        if (!level.keys.insert(name).second)
            return complain(
                fmt::format("'{}' stands twice in one object, expected it once", shown_text(name)));
        std::get<Object>(level.value.value).push_back({name, {}});
        return true;
    }

    bool parse_error(std::size_t position,
                     const std::string& token,
                     const nlohmann::json::exception& error) {
        if (error.id == number_too_large)
            return complain(fmt::format("{} is beyond all numbers that can be held", token));
        if (position > text_.size())
            return complain("the JSON ends before it is complete");
        const auto byte = std::max<std::size_t>(position, 1);
        return complain(fmt::format("not JSON from '{}' on, byte {} of the file",
                                    shown_text(text_.substr(byte - 1)), byte));
    }

  private:
    struct Level {
        JsonValue value;
        std::set<std::string> keys;
    };

    /// Of the value that was read last.  The byte after a number has been read as well.
    int line() {
        const auto last = std::max(static_cast<std::ptrdiff_t>(1), seen_ - text_.data()) - 1;
        line_ +=
            static_cast<int>(std::count(text_.data() + counted_to_, text_.data() + last, '\n'));
        counted_to_ = std::max(counted_to_, last);
        return line_;
    }

    bool complain(const std::string& what) {
        complaint = fmt::format("{}: {}", line(), what);
        return false;
    }

    bool put(JsonValue value) {
        if (levels_.empty())
            whole = std::move(value);
        else if (auto* object = std::get_if<Object>(&levels_.back().value.value))
            object->back().value = std::move(value);
        else
            std::get<List>(levels_.back().value.value).push_back(std::move(value));
        return true;
    }

    template <class Value>
    bool take(Value value) {
        return put({std::move(value), line()});
    }

    template <class Value>
    bool open(Value value) {
        if (levels_.size() == most_levels)
            return complain(fmt::format("more than {} levels of lists and objects", most_levels));
        levels_.push_back({{std::move(value), line()}, {}});
        return true;
    }

    bool close() {
        auto value = std::move(levels_.back().value);
        levels_.pop_back();
        return put(std::move(value));
    }

    std::string_view text_;
    const char* seen_;
    std::ptrdiff_t counted_to_ = 0;
    int line_ = 1;
    std::vector<Level> levels_;
};

std::optional<std::string> what_no_text_has(std::string_view text) {
    const auto line_of = [&](std::size_t place) {
        return 1 +
               std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    };
    if (text.find_first_not_of(" \t\r\n") == text.npos)
        return "1: the file is empty";
    if (const auto line = analysis::first_line_not_utf8(text))
        return fmt::format("{}: a byte that is no UTF-8", *line);
    if (const auto zero = text.find('\0'); zero != text.npos)
        return fmt::format("{}: a zero byte, which no text holds", line_of(zero));
    return std::nullopt;
}

} // namespace

tl::expected<JsonValue, std::string> read_json(std::string_view text, std::string_view file_name) {
    if (const auto wrong = what_no_text_has(text))
        return tl::unexpected(fmt::format("{}:{}", file_name, *wrong));
    Builder builder(text);
    if (!nlohmann::json::sax_parse(builder.begin(), builder.end(), &builder))
        return tl::unexpected(fmt::format("{}:{}", file_name, builder.complaint));
    return std::move(builder.whole);
}

const std::vector<JsonMember>& JsonPlace::object() const {
    const auto* members = std::get_if<Object>(&value_->value);
    if (members == nullptr)
        refuse("an object in braces");
    return *members;
}

const JsonValue* JsonPlace::find(std::string_view key) const {
    const auto& members = object();
    const auto found = std::ranges::find(members, key, &JsonMember::key);
    return found == members.end() ? nullptr : &found->value;
}

std::string JsonPlace::way_to(std::string_view key) const {
    return way_.empty() ? std::string(key) : fmt::format("{}.{}", way_, key);
}

bool JsonPlace::has(std::string_view key) const {
    return find(key) != nullptr;
}

JsonPlace JsonPlace::at(std::string_view key) const {
    const auto* member = find(key);
    if (member == nullptr)
        complain(fmt::format("there is no {}", way_to(key)));
    return {*member, way_to(key)};
}

std::vector<JsonPlace> JsonPlace::elements() const {
    const auto* list = std::get_if<List>(&value_->value);
    if (list == nullptr)
        refuse("a list in brackets");
    std::vector<JsonPlace> places;
    for (const auto& element : *list)
        places.emplace_back(element, fmt::format("{}[{}]", way_, places.size()));
    return places;
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
    std::vector<std::pair<std::string, JsonPlace>> places;
    for (const auto& [key, value] : object())
        places.emplace_back(key, JsonPlace(value, way_to(key)));
    return places;
}

std::string JsonPlace::text() const {
    const auto* text = std::get_if<std::string>(&value_->value);
    if (text == nullptr)
        refuse("a text in quotes");
    return *text;
}

double JsonPlace::number() const {
    if (const auto* number = std::get_if<double>(&value_->value))
        return *number;
    if (const auto* whole = std::get_if<std::uint64_t>(&value_->value))
        return static_cast<double>(*whole);
    if (const auto* below = std::get_if<std::int64_t>(&value_->value))
        return static_cast<double>(*below);
    refuse("a number");
}

int JsonPlace::count() const {
    constexpr auto most = std::numeric_limits<int>::max();
    const auto whole = size();
    if (whole > static_cast<std::size_t>(most))
        refuse(fmt::format("a whole number from 0 to {}", most));
    return static_cast<int>(whole);
}

std::size_t JsonPlace::size() const {
    const auto* whole = std::get_if<std::uint64_t>(&value_->value);
    if (whole == nullptr)
        refuse("a whole number from 0");
    return *whole;
}

void JsonPlace::refuse(std::string_view wanted) const {
    complain(fmt::format("{} is {}, expected {}", way_.empty() ? "the outermost value" : way_,
                         shown(*value_), wanted));
}

void JsonPlace::complain(std::string_view what) const {
    throw JsonMisfit(value_->line, std::string(what));
}

} // namespace experiment
