// Numbers are compared so that NaN fails.
#include "experiment/commands/option.h"

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

} // namespace

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
    const auto refuse = [least, most](const std::string& input) {
        double value = 0;
        if (CLI::detail::lexical_cast(input, value) && value >= least && value <= most)
            return std::string();
        return fmt::format("{} is not a number from {} to {}", input, least, most);
    };
    option_->check(refuse, fmt::format("[{} - {}]", least, most));
    return *this;
}

Option Option::one_of(const std::vector<std::string>& words) {
    const auto refuse = [words](const std::string& input) {
        return std::ranges::find(words, input) == words.end() ? none_of_them(input, words)
                                                              : std::string();
    };
    option_->check(refuse, fmt::format("{{{}}}", fmt::join(words, ",")));
    return *this;
}

Option Option::not_blank(const std::string& wanted) {
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
    option_->check(CLI::ExistingDirectory);
    return *this;
}

} // namespace experiment::commands
