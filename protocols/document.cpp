// The one door to toml++.
#include "protocols/document.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstddef>

namespace protocols {

namespace {

int line_of(const toml::source_region& source) {
    return std::max(1, static_cast<int>(source.begin.line));
}

Node to_node(const toml::node& node);

Table to_table(const toml::table& table) {
    Table entries;
    for (const auto& [key, value] : table)
        entries.push_back({std::string(key.str()), line_of(key.source()), to_node(value)});
    return entries;
}

List to_list(const toml::array& array) {
    List nodes;
    for (const auto& element : array)
        nodes.push_back(to_node(element));
    return nodes;
}

Node to_node(const toml::node& node) {
    const int line = line_of(node.source());
    if (const auto* table = node.as_table())
        return {to_table(*table), line};
    if (const auto* array = node.as_array())
        return {to_list(*array), line};
    if (const auto* text = node.as_string())
        return {text->get(), line};
    if (const auto* whole = node.as_integer())
        return {whole->get(), line};
    if (const auto* number = node.as_floating_point())
        return {number->get(), line};
    if (const auto* truth = node.as_boolean())
        return {truth->get(), line};
    return {Moment{}, line};
}

// Every part is a table in a table, and those are gone through and dropped one within the other.
constexpr int most_parts = 64;

/// Past a quoted text, or to the end of the line where it does not end there.
std::size_t after_quotes(std::string_view text, std::size_t at) {
    const char quote = text[at];
    for (++at; at < text.size() && text[at] != '\n' && text[at] != quote; ++at)
        if (quote == '"' && text[at] == '\\')
            ++at;
    return at;
}

/// The line of the first key whose dots are more than anybody means; 0 when there is none.
int line_of_deep_key(std::string_view text) {
    int line = 1, dots = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '#')
            at = std::min(text.find('\n', at), text.size()) - 1;
        else if (c == '"' || c == '\'')
            at = after_quotes(text, at);
        else if (c == '.')
            ++dots;
        else if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos)
            dots = 0;
        if (dots >= most_parts)
            return line;
        if (at < text.size() && text[at] == '\n') {
            ++line;
            dots = 0;
        }
    }
    return 0;
}

} // namespace

Expected<Table> read_document(std::string_view text, std::string_view file_name) {
    if (const auto line = line_of_deep_key(text); line > 0)
        return tl::unexpected(
            fmt::format("{}:{}: a key of more than {} parts, expected key = value", file_name, line,
                        most_parts));
    try {
        return to_table(toml::parse(text, file_name));
    } catch (const toml::parse_error& error) {
        return tl::unexpected(
            fmt::format("{}:{}: not TOML: {}; mend this line, expected key = value "
                        "with text in quotes, or a table's name in brackets",
                        file_name, line_of(error.source()), error.description()));
    }
}

namespace {

// As much of a list as a message has room for.
std::string shown_list(const List& list) {
    constexpr std::size_t most = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(list.size(), most); ++i)
        text += (i > 0 ? ", " : "") + shown(list[i]);
    return fmt::format("[{}{}]", text, list.size() > most ? ", ..." : "");
}

} // namespace

std::string shown(const Node& node) {
    if (const auto* text = std::get_if<std::string>(&node.value))
        return fmt::format("\"{}\"", *text);
    if (const auto* whole = std::get_if<std::int64_t>(&node.value))
        return fmt::format("{}", *whole);
    if (const auto* number = std::get_if<double>(&node.value))
        return fmt::format("{}", *number);
    if (const auto* truth = std::get_if<bool>(&node.value))
        return *truth ? "true" : "false";
    if (const auto* list = std::get_if<List>(&node.value))
        return shown_list(*list);
    return std::holds_alternative<Table>(node.value) ? "a table" : "a date or time";
}

} // namespace protocols
