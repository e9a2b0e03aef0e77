// What every command of the program shares: how it fails, how it speaks.
#pragma once

#include <tl/expected.hpp>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace experiment::commands {

class Command;

/// What was asked could not be done; the message is for the person who asked.  Caught once, in
/// main.
class CommandError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The value, or the command ends with the message.
template <class T>
T value_or_stop(tl::expected<T, std::string> result) {
    if (!result)
        throw CommandError(result.error());
    if constexpr (!std::is_void_v<T>)
        return std::move(*result);
}

/// `--quiet`: no progress and no remarks, only results and errors.
struct Voice {
    bool quiet = false;

    /// A remark on the way, to standard error.
    void remark(const std::string& text) const;

    /// Whether a result's text for people is printed beside its JSON: without JSON always, and
    /// never where standard output is the JSON's.
    bool says_text_beside(const std::string& json) const;
};

/// Adds `--quiet` to `command`.
void add_voice(Command& command, Voice& voice);

/// Whether `path` stands for no file: empty, or "-".
bool is_standard_output(const std::string& path);

/// Files that a result is made from.
using Inputs = std::vector<std::filesystem::path>;

/// That nothing is lost where the file `path` is written.
/// Errors: CommandError for one of `inputs`, by whatever name, and for what a study folder keeps
/// (study.toml, votes.sqlite, ...).
void expect_not_lost(const std::filesystem::path& path, const Inputs& inputs);

/// Writes a result to the file `path`, or to standard output (`is_standard_output`).
/// Errors: those of `expect_not_lost`, and CommandError for a file that cannot be written.
void deliver(const std::string& text, const std::string& path, const Inputs& inputs);

} // namespace experiment::commands
