// Lines and fields of a text file held in memory, with line numbers for messages.
#include "renderer/geometry/text_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace renderer::geometry {

namespace {

template <class Number>
std::optional<Number> parse_whole(std::string_view field) {
    Number value{};
    const auto* end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, value);
    if (error != std::errc{} || stop != end)
        return std::nullopt;
    return value;
}

} // namespace

Lines::Lines(std::string_view text) : rest_(text) {
    const auto first_end = text.find_first_of("\r\n");
    if (first_end != text.npos && text[first_end] == '\r' && text.substr(first_end + 1, 1) != "\n")
        ending_ = '\r';
}

std::optional<std::string_view> Lines::next() {
    if (rest_.empty())
        return std::nullopt;
    const auto length = rest_.find(ending_);
    auto line = rest_.substr(0, length);
    rest_.remove_prefix(length == rest_.npos ? rest_.size() : length + 1);
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    ++number_;
    return line;
}

void split_fields(std::string_view line, std::vector<std::string_view>& fields) {
    constexpr std::string_view blanks = " \t";
    fields.clear();
    for (;;) {
        const auto begin = line.find_first_not_of(blanks);
        if (begin == line.npos)
            return;
        const auto end = std::min(line.find_first_of(blanks, begin), line.size());
        fields.push_back(line.substr(begin, end - begin));
        line.remove_prefix(end);
    }
}

std::optional<double> parse_real(std::string_view field) {
    if (field.starts_with('+'))
        field.remove_prefix(1);
    return parse_whole<double>(field);
}

std::optional<std::size_t> parse_count(std::string_view field) {
    return parse_whole<std::size_t>(field);
}

std::string shown(std::string_view field) {
    constexpr std::size_t longest = 24;
    std::string text = "'";
    for (const char c : field.substr(0, longest))
        text += c >= ' ' && c <= '~' ? c : '?';
    return text + (field.size() > longest ? "...'" : "'");
}

std::string at_line(std::string_view name, std::size_t line, std::string_view what) {
    // of a text without lines, the first is missed
    return fmt::format("{}:{}: {}", name, std::max<std::size_t>(line, 1), what);
}

} // namespace renderer::geometry
