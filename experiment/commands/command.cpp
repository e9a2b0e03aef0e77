// Remarks go to standard error, results to standard output.
#include "experiment/commands/command.h"

#include "experiment/commands/command_line.h"
#include "experiment/text_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace experiment::commands {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 4> kept_by_studies{"study.toml", "instructions.md",
                                                          "votes.sqlite", "manifest.json"};

/// A folder on the way that is not there yet will be made: then the words alone say what it is.
fs::path spelled(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(path, ignored).lexically_normal(), ignored);
}

bool is_same_file(const fs::path& path, const fs::path& input) {
    std::error_code ignored;
    if (input.empty())
        return false;
    return fs::exists(path, ignored) ? fs::equivalent(path, input, ignored)
                                     : spelled(path) == spelled(input);
}

} // namespace

void Voice::remark(const std::string& text) const {
    if (!quiet)
        fmt::print(stderr, "{}\n", text);
}

bool Voice::says_text_beside(const std::string& json) const {
    return json.empty() || !(quiet || is_standard_output(json));
}

void add_voice(Command& command, Voice& voice) {
    command.add_flag("-q,--quiet", voice.quiet, "Say nothing on the way: results and errors only");
}

bool is_standard_output(const std::string& path) {
    return path.empty() || path == "-";
}

void expect_not_lost(const fs::path& path, const Inputs& inputs) {
    std::error_code ignored;
    const bool is_input = std::ranges::any_of(
        inputs, [&](const fs::path& input) { return is_same_file(path, input); });
    const bool is_kept = fs::exists(path, ignored) &&
                         std::ranges::count(kept_by_studies, path.filename().string()) > 0;
    if (is_input || is_kept)
        throw CommandError(
            fmt::format("{}: would be written over and lost; name another file", path.string()));
}

void deliver(const std::string& text, const std::string& path, const Inputs& inputs) {
    if (is_standard_output(path)) {
        fmt::print("{}", text);
        return;
    }
    expect_not_lost(path, inputs);
    value_or_stop(write_text_file(path, text));
}

} // namespace experiment::commands
