// Numbers are compared so that NaN fails.
#include "experiment/commands/option.h"

#include "experiment/commands/number_words.h"
#include "protocols/spelling.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <system_error>

namespace experiment::commands {

namespace {

std::string none_of_them(const std::string& word, const std::vector<std::string>& words) {
    const auto nearest = protocols::nearest_name(word, words);
    return fmt::format("'{}', expected {}{}{}", word, words.size() > 1 ? "one of " : "",
                       fmt::join(words, ", "),
                       nearest ? fmt::format(" (did you mean '{}'?)", *nearest) : "");
}

/// The check runs before those that are there already: what is no value at all is said first.
void ask_first(CLI::Option& option,
               const std::function<std::string(std::string&)>& check,
               const std::string& shown = "",
               const std::string& name = "") {
    option.transform(CLI::Validator(check, shown, name));
}

/// The parser reads 010 as 8, and what is too large or below 0 as some other number: it gets what
/// it cannot misread.
template <class Whole>
void expect_whole(CLI::Option& option) {
    ask_first(option, [](std::string& word) {
        const auto value = number_in<Whole>(word);
        if (!value)
            return fmt::format("{} is not a whole number from {} to {}", word,
                               std::numeric_limits<Whole>::min(),
                               std::numeric_limits<Whole>::max());
        word = fmt::format("{}", *value);
        return std::string();
    });
}

bool holds_whole_numbers(const CLI::Option& option) {
    return option.get_type_name().find("INT") != std::string::npos;
}

constexpr const char* text_check = "text";

} // namespace

Option Option::holds_int() {
    expect_whole<int>(*option_);
    return *this;
}

Option Option::holds_unsigned() {
    expect_whole<std::uint64_t>(*option_);
    return *this;
}

Option Option::holds_number() {
    ask_first(*option_, [](std::string& word) {
        const auto value = number_in<double>(word);
        return value && std::isfinite(*value) ? std::string()
                                              : fmt::format("{} is not a number", word);
    });
    return *this;
}

Option Option::holds_text() {
    ask_first(
        *option_,
        [](std::string& word) {
            return word.empty() ? std::string("\"\" says nothing, expected a text") : std::string();
        },
        "", text_check);
    return *this;
}

void Option::drop_text_check() {
    option_->get_validator(text_check)->active(false);
}

Option Option::may_be_empty() {
    drop_text_check();
    return *this;
}

Option Option::required() {
    option_->required();
    return *this;
}

Option Option::excludes(Option other) {
    option_->excludes(other.option_);
    return *this;
}

Option Option::shows_default() {
    option_->capture_default_str();
    return *this;
}

Option Option::shown_as(const std::string& kind) {
    option_->type_name(kind);
    return *this;
}

Option Option::separated_by(char mark) {
    option_->delimiter(mark);
    return *this;
}

Option Option::within(double least, double most) {
    const bool is_whole = holds_whole_numbers(*option_);
    const auto refuse = [is_whole, least, most](const std::string& word) {
        if (is_whole && !spells_whole_number(word))
            return fmt::format("{} is not a whole number from {} to {}", word, least, most);
        const auto value = number_in<double>(word);
        return value && *value >= least && *value <= most
                   ? std::string()
                   : fmt::format("{} is not a number from {} to {}", word, least, most);
    };
    ask_first(*option_, refuse, fmt::format("[{} - {}]", least, most));
    return *this;
}

Option Option::one_of(const std::vector<std::string>& words) {
    drop_text_check();
    const auto refuse = [words](const std::string& input) {
        return std::ranges::find(words, input) == words.end() ? none_of_them(input, words)
                                                              : std::string();
    };
    option_->check(refuse, fmt::format("{{{}}}", fmt::join(words, ",")));
    return *this;
}

Option Option::not_blank(const std::string& wanted) {
    drop_text_check();
    option_->check([wanted](const std::string& input) {
        return input.find_first_not_of(" \t\r\n") == std::string::npos
                   ? fmt::format("\"{}\" says nothing, expected {}", input, wanted)
                   : std::string();
    });
    return *this;
}

Option Option::not_standard_output() {
    option_->check([](const std::string& input) {
        return input == "-" ? std::string("- is standard output, which holds one file; "
                                          "expected a name, or ./- for one that is called so")
                            : std::string();
    });
    return *this;
}

Option Option::existing_folder() {
    const auto refuse = [](const std::string& input) {
        std::error_code ignored;
        return std::filesystem::is_directory(input, ignored)
                   ? std::string()
                   : fmt::format("{} is not a folder that is there", input);
    };
    option_->check(refuse, "DIR");
    return *this;
}

} // namespace experiment::commands
