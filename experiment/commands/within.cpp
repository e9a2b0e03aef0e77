// Numbers are compared so that NaN fails.
#include "experiment/commands/within.h"

#include "protocols/spelling.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace experiment::commands {

namespace {

std::string none_of_them(const std::string& word, const std::vector<std::string>& words) {
    const auto nearest = protocols::nearest_name(word, words);
    return fmt::format("'{}', expected {}{}{}", word, words.size() > 1 ? "one of " : "",
                       fmt::join(words, ", "),
                       nearest ? fmt::format(" (did you mean '{}'?)", *nearest) : "");
}

/// For the line of help.
std::string in_braces(const std::vector<std::string>& words) {
    return fmt::format("{{{}}}", fmt::join(words, ","));
}

} // namespace

CLI::Validator one_of(const std::vector<std::string>& words) {
    return CLI::Validator(
        [words](const std::string& input) {
            return std::ranges::find(words, input) == words.end() ? none_of_them(input, words)
                                                                  : std::string();
        },
        in_braces(words));
}

CLI::Validator word_for(const std::map<std::string, int>& numbers) {
    std::vector<std::string> words;
    for (const auto& [word, number] : numbers)
        words.push_back(word);
    return CLI::Validator(
        [numbers, words](std::string& input) {
            const auto found = numbers.find(input);
            if (found == numbers.end())
                return none_of_them(input, words);
            input = std::to_string(found->second);
            return std::string();
        },
        in_braces(words));
}

CLI::Validator not_standard_output() {
    return CLI::Validator(
        [](const std::string& input) {
            return input == "-" ? std::string("- is standard output, which holds one file; "
                                              "expected a name, or ./- for one that is called so")
                                : std::string();
        },
        "");
}

CLI::Validator within(double least, double most) {
    const auto refuse = [least, most](const std::string& input) {
        double value = 0;
        if (CLI::detail::lexical_cast(input, value) && value >= least && value <= most)
            return std::string();
        return fmt::format("{} is not a number from {} to {}", input, least, most);
    };
    return CLI::Validator(refuse, fmt::format("[{} - {}]", least, most));
}

CLI::Validator not_blank(const char* wanted) {
    return CLI::Validator(
        [wanted](const std::string& input) {
            return input.find_first_not_of(" \t\r\n") == std::string::npos
                       ? fmt::format("\"{}\" says nothing, expected {}", input, wanted)
                       : std::string();
        },
        "");
}

} // namespace experiment::commands
