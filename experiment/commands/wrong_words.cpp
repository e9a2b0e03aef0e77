// The words are gone through as the parser does it, with what the parser knows of options.
#include "experiment/commands/wrong_words.h"

#include "experiment/commands/command.h"
#include "protocols/spelling.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace experiment::commands {

namespace {

const CLI::App* command_called(const CLI::App& app, const std::string& name) {
    for (const auto* command : app.get_subcommands({}))
        if (command->get_name() == name)
            return command;
    return nullptr;
}

/// The option a word names, without what it is set to in the word itself (--option=value).
const CLI::Option* option_called(const CLI::App& app, const std::string& word) {
    const auto name = word.substr(0, word.find('='));
    return name.size() > 1 && name[0] == '-' ? app.get_option_no_throw(name) : nullptr;
}

int values_needed(const CLI::Option& option) {
    return option.get_type_size_max() == 0 ? 0 : option.get_items_expected_min();
}

[[noreturn]] void refuse(const std::string& option,
                         std::span<const char* const> given,
                         int needed,
                         const char* next) {
    std::string text = option;
    for (const auto* value : given)
        text += fmt::format(" {}", value);
    throw CommandError(fmt::format(
        "{}: {} given{}, expected {}", text,
        given.empty() ? "no value"
                      : fmt::format("{} value{}", given.size(), given.size() == 1 ? "" : "s"),
        next == nullptr ? "" : fmt::format(" before {}", next), needed));
}

/// How many of the words after an option are its own; refuses where they are too few.
std::size_t values_of(const CLI::App& app,
                      const CLI::Option& option,
                      const std::string& word,
                      std::span<const char* const> after) {
    const int needed = word.find('=') == std::string::npos ? values_needed(option) : 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(needed); ++k)
        if (k == after.size() || option_called(app, after[k]) != nullptr)
            refuse(word, after.first(k), needed, k == after.size() ? nullptr : after[k]);
    return static_cast<std::size_t>(needed);
}

/// "Could not convert: --rounds = 1.5" of the parser.
std::string conversion_complaint(const CLI::App& command, const std::string& said) {
    constexpr std::string_view before = "Could not convert: ", between = " = ";
    const auto split = said.find(between);
    if (!said.starts_with(before) || split == std::string::npos)
        return said;
    const auto name = said.substr(before.size(), split - before.size());
    const auto value = said.substr(split + between.size());
    const auto* option = command.get_option_no_throw(name);
    const bool is_real =
        option != nullptr && option->get_type_name().find("FLOAT") != std::string::npos;
    return fmt::format("{}: {} is not {}", name, value,
                       is_real ? "a number"
                               : "a whole number it "
                                 "takes");
}

} // namespace

void expect_command(const CLI::App& program, std::span<const char* const> words) {
    if (words.size() < 2)
        return;
    const std::string word = words[1];
    std::vector<std::string> names;
    for (const auto* command : program.get_subcommands({}))
        names.push_back(command->get_name());
    if (word.starts_with("-") || std::ranges::count(names, word) > 0)
        return;
    const auto nearest = protocols::nearest_name(word, names);
    throw CommandError(fmt::format("there is no command '{}'{}; `pairlight --help` lists them",
                                   word,
                                   nearest ? fmt::format(" (did you mean '{}'?)", *nearest) : ""));
}

void expect_values(const CLI::App& program, std::span<const char* const> words) {
    const auto* app = &program;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string word = words[i];
        if (word == "--")
            return;
        if (const auto* option = option_called(*app, word))
            i += values_of(*app, *option, word, words.subspan(i + 1));
        else if (const auto* command = command_called(*app, word))
            app = command;
    }
}

std::string complaint_of(const CLI::App& program, const CLI::ParseError& error) {
    const auto* command = &program;
    std::string name = "pairlight";
    while (!command->get_subcommands().empty()) {
        command = command->get_subcommands().front();
        name += " " + command->get_name();
    }
    return fmt::format("{}; `{} --help` lists the options",
                       conversion_complaint(*command, error.what()), name);
}

} // namespace experiment::commands
