// The words are gone through as the parser does it, with what the parser knows of options.
#include "experiment/commands/wrong_words.h"

#include "experiment/commands/command.h"
#include "protocols/spelling.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
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
                         std::span<const char* const> after,
                         std::size_t given,
                         int needed,
                         const char* next) {
    std::string text = option;
    for (const auto* value : after)
        text += fmt::format(" {}", value);
    throw CommandError(fmt::format(
        "{}: {} given{}, expected {}", text,
        given == 0 ? "no value" : fmt::format("{} value{}", given, given == 1 ? "" : "s"),
        next == nullptr ? "" : fmt::format(" before {}", next), needed));
}

/// How many of the words after an option are its own; refuses where they are too few.
std::size_t values_of(const CLI::App& app,
                      const CLI::Option& option,
                      const std::string& word,
                      std::span<const char* const> after) {
    const int needed = values_needed(option);
    const auto equals = word.find('=');
    const bool has_own = equals != std::string::npos;
    if (has_own && needed == 0)
        throw CommandError(fmt::format("{}: {} takes no value", word, word.substr(0, equals)));
    if (has_own && equals + 1 == word.size())
        refuse(word, {}, 0, needed, nullptr);
    const auto missing = static_cast<std::size_t>(has_own ? needed - 1 : needed);
    for (std::size_t k = 0; k < missing; ++k)
        if (k == after.size() || option_called(app, after[k]) != nullptr)
            refuse(word, after.first(k), k + (has_own ? 1 : 0), needed,
                   k == after.size() ? nullptr : after[k]);
    return missing;
}

bool is_taken_once(const CLI::Option& option) {
    return option.get_expected_max() <= 1;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const auto* option : command.get_options())
        for (const auto& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

/// The only name that begins like this, or the nearest.
std::optional<std::string> name_meant(const std::string& word,
                                      const std::vector<std::string>& names) {
    const auto begins = [&](const std::string& name) { return name.starts_with(word); };
    if (word.size() > 2 && std::ranges::count_if(names, begins) == 1)
        return *std::ranges::find_if(names, begins);
    return protocols::nearest_name(word, names);
}

/// Of the words that the parser had no place for; "" where there are none.
std::string complaint_of_left_words(const CLI::App& program, const CLI::App& command) {
    auto words = program.remaining(true);
    std::erase(words, "--");
    const auto option =
        std::ranges::find_if(words, [](const auto& word) { return word.starts_with('-'); });
    if (option != words.end()) {
        const auto name = option->substr(0, option->find('='));
        const auto meant = name_meant(name, option_names(command));
        return fmt::format("there is no option '{}'{}", name,
                           meant ? fmt::format(" (did you mean '{}'?)", *meant) : "");
    }
    return words.empty() ? ""
                         : fmt::format("'{}': {} more than expected", fmt::join(words, " "),
                                       words.size() == 1 ? "a word" : "words");
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
    std::set<const CLI::Option*> seen;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string word = words[i];
        if (word == "--")
            return;
        if (const auto* option = option_called(*app, word)) {
            i += values_of(*app, *option, word, words.subspan(i + 1));
            if (!seen.insert(option).second && is_taken_once(*option))
                throw CommandError(fmt::format("{}: given twice, expected it once",
                                               word.substr(0, word.find('='))));
        } else if (const auto* command = command_called(*app, word))
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
    const auto left = complaint_of_left_words(program, *command);
    const bool is_of_a_value = dynamic_cast<const CLI::ValidationError*>(&error) != nullptr;
    return fmt::format("{}; `{} --help` lists the options",
                       left.empty() || is_of_a_value ? error.what() : left, name);
}

} // namespace experiment::commands
