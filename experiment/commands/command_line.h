// The words after `pairlight`, as commands ask for them.  The library that reads them is slow to
// compile: it ends here, and no command includes it.
#pragma once

#include "experiment/commands/option.h"

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace CLI {
class App;
}

namespace experiment::commands {

/// A handle of a command, or of the program that holds all of them.  What it stands for lives as
/// long as the command line does.
class Command {
  public:
    explicit Command(CLI::App* app) : app_(app) {}

    std::string name() const;

    Command add_command(const char* name, const char* description);

    /// `value` is what holds without the option; what was given is there when the command runs, so
    /// it has to live as long.  A name without dashes is that of a word at a place of its own.
    template <class T>
    Option add_option(const char* name, T& value, const char* description) {
        return add_option_at(name, Place(&value), description);
    }

    /// An option that takes one of the words, each of which stands for a value.
    template <class T>
    Option add_choice(const char* name,
                      T& value,
                      const char* description,
                      const std::map<std::string, T>& words) {
        std::vector<std::string> known;
        for (const auto& [word, meaning] : words)
            known.push_back(word);
        return add_word(
            name, [&value, words](const std::string& word) { value = words.at(word); }, description,
            known);
    }

    /// An option without a value; `names` such as "-q,--quiet".
    Option add_flag(const char* names, bool& given, const char* description);

    /// What the command does, unless one of its own commands was named.
    void runs(std::function<void()> action);

    bool was_given(const char* option) const;

    /// The options that were given, in the order in which they were added.
    std::vector<std::string> given_options() const;

    /// That none of the options was given, where they would change nothing: who gives them expects
    /// that they do.
    /// Errors: CommandError "--material: <why>" for the first that was.
    void expect_not_given(std::initializer_list<const char*> options, const std::string& why) const;

  private:
    using Place = std::variant<int*,
                               std::uint64_t*,
                               double*,
                               std::string*,
                               std::array<int, 2>*,
                               std::array<double, 3>*,
                               std::optional<std::string>*,
                               std::optional<std::array<double, 3>>*,
                               std::vector<int>*,
                               std::vector<std::string>*>;

    Option add_option_at(const char* name, Place place, const char* description);
    Option add_word(const char* name,
                    const std::function<void(const std::string&)>& take,
                    const char* description,
                    const std::vector<std::string>& words);

    CLI::App* app_;
};

/// The program with all its commands.
class CommandLine {
  public:
    /// `version` is what --version prints.
    CommandLine(const char* name, const char* description, const char* version);
    ~CommandLine();

    Command program();

    /// Does what the words ask for; the first of them is the program's own.  The exit status: not 0
    /// where they cannot be understood, which is said on standard error.
    /// Errors: CommandError, and whatever the command throws.
    int run(std::span<const char* const> words);

  private:
    std::unique_ptr<CLI::App> app_;
};

} // namespace experiment::commands
