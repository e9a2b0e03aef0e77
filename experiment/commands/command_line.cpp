// Every command is an App of CLI11, every option one of its Options.
#include "experiment/commands/command_line.h"

#include "experiment/commands/command.h"
#include "experiment/commands/wrong_words.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdlib>

namespace experiment::commands {

namespace {

// What is asked of the values of each type that an option may hold.

void ask_for_kind(Option option, const int&) {
    option.holds_int();
}

void ask_for_kind(Option option, const std::uint64_t&) {
    option.holds_unsigned();
}

void ask_for_kind(Option option, const double&) {
    option.holds_number();
}

void ask_for_kind(Option option, const std::string&) {
    option.holds_text();
}

template <class T, std::size_t count>
void ask_for_kind(Option option, const std::array<T, count>&) {
    ask_for_kind(option, T{});
}

template <class T>
void ask_for_kind(Option option, const std::optional<T>&) {
    ask_for_kind(option, T{});
}

template <class T>
void ask_for_kind(Option option, const std::vector<T>&) {
    ask_for_kind(option, T{});
}

} // namespace

std::string Command::name() const {
    return app_->get_name();
}

Command Command::add_command(const char* name, const char* description) {
    return Command(app_->add_subcommand(name, description));
}

Option Command::add_option_at(const char* name, Place place, const char* description) {
    return std::visit(
        [&](auto* value) {
            const Option option(app_->add_option(name, *value, description));
            ask_for_kind(option, *value);
            return option;
        },
        place);
}

Option Command::add_word(const char* name,
                         const std::function<void(const std::string&)>& take,
                         const char* description,
                         const std::vector<std::string>& words) {
    return Option(app_->add_option_function<std::string>(name, take, description))
        .shown_as("ENUM")
        .holds_text()
        .one_of(words);
}

Option Command::add_flag(const char* names, bool& given, const char* description) {
    return Option(app_->add_flag(names, given, description));
}

void Command::runs(std::function<void()> action) {
    app_->callback([app = app_, action = std::move(action)] {
        if (app->get_subcommands().empty())
            action();
    });
}

bool Command::was_given(const char* option) const {
    return app_->get_option(option)->count() > 0;
}

std::vector<std::string> Command::given_options() const {
    std::vector<std::string> names;
    for (const auto* option : app_->get_options())
        if (option->count() > 0)
            names.push_back(option->get_name());
    return names;
}

void Command::expect_not_given(std::initializer_list<const char*> options,
                               const std::string& why) const {
    for (const auto* option : options)
        if (was_given(option))
            throw CommandError(fmt::format("{}: {}", option, why));
}

CommandLine::CommandLine(const char* name, const char* description, const char* version)
    : app_(std::make_unique<CLI::App>(description, name)) {
    app_->set_version_flag("--version", version, "Print the version and end");
    app_->require_subcommand(1); // which commands inherit: at most one of their own
}

CommandLine::~CommandLine() = default;

Command CommandLine::program() {
    return Command(app_.get());
}

int CommandLine::run(std::span<const char* const> words) {
    try {
        expect_command(*app_, words);
        expect_values(*app_, words);
        app_->parse(static_cast<int>(words.size()), words.data());
    } catch (const CLI::Success& help) {
        return app_->exit(help);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "pairlight: {}\n", complaint_of(*app_, error));
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}

} // namespace experiment::commands
