// What is wrong with the words after `pairlight`, where the parser would blame the wrong one or say
// so in words of its own.  Only the command line asks.
#pragma once

#include <span>
#include <string>

namespace CLI {
class App;
class ParseError;
} // namespace CLI

namespace experiment::commands {

/// That the program's first word, where it is no option, names one of its commands:
/// the parser would say that there is none.
/// Errors: CommandError, with the command that was probably meant.
void expect_command(const CLI::App& program, std::span<const char* const> words);

/// That every option has as many values as it needs before the next option, for the parser would
/// take that for a value, and complain of it or, worse, not at all; that a flag has none; and that
/// what holds one thing is given once.
/// Errors: CommandError, with the option, what it was given and how many it takes.
void expect_values(const CLI::App& program, std::span<const char* const> words);

/// The parser's complaint, or what is better said of the words it had no place for; and where to
/// read on.
std::string complaint_of(const CLI::App& program, const CLI::ParseError& error);

} // namespace experiment::commands
