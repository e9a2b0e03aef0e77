// The standard library reads decimal numbers and no others; it does not know a leading plus.
#include "experiment/commands/number_words.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <system_error>

namespace experiment::commands {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string_view without_plus(std::string_view word) {
    const bool has_plus =
        word.size() > 1 && word[0] == '+' && (is_digit(word[1]) || word[1] == '.');
    return has_plus ? word.substr(1) : word;
}

} // namespace

template <class Number>
std::optional<Number> number_in(std::string_view word) {
    const auto digits = without_plus(word);
    const auto* end = digits.data() + digits.size();
    Number number{};
    const auto [stopped, error] = std::from_chars(digits.data(), end, number);
    if (error != std::errc() || stopped != end)
        return std::nullopt;
    return number;
}

template std::optional<int> number_in(std::string_view);
template std::optional<std::uint64_t> number_in(std::string_view);
template std::optional<double> number_in(std::string_view);

bool spells_whole_number(std::string_view word) {
    if (!word.empty() && (word[0] == '-' || word[0] == '+'))
        word.remove_prefix(1);
    return !word.empty() && std::ranges::all_of(word, is_digit);
}

} // namespace experiment::commands
