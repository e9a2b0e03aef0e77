// Remarks go to standard error, results to standard output.
#include "experiment/commands/command.h"

#include "experiment/text_files.h"
#include "protocols/spelling.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

namespace experiment::commands {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 4> kept_by_studies{"study.toml", "instructions.md",
                                                          "votes.sqlite", "manifest.json"};

void refuse_to_overwrite(const fs::path& path, const fs::path& input) {
    std::error_code ignored;
    // A folder on the way that is not there yet will be made: then the words alone say what it is.
    const auto spelled = [&](const fs::path& p) {
        return fs::weakly_canonical(fs::absolute(p, ignored).lexically_normal(), ignored);
    };
    const bool is_input =
        !input.empty() && ((fs::exists(path, ignored) && fs::equivalent(path, input, ignored)) ||
                           (fs::exists(input, ignored) && spelled(path) == spelled(input)));
    const bool is_kept = fs::exists(path, ignored) &&
                         std::ranges::count(kept_by_studies, path.filename().string()) > 0;
    if (is_input || is_kept)
        throw CommandError(
            fmt::format("{}: would be written over and lost; name another file", path.string()));
}

} // namespace

void Voice::remark(const std::string& text) const {
    if (!quiet)
        fmt::print(stderr, "{}\n", text);
}

bool Voice::says_text_beside(const std::string& json) const {
    return json.empty() || !(quiet || is_standard_output(json));
}

void add_voice(CLI::App& command, Voice& voice) {
    command.add_flag("-q,--quiet", voice.quiet, "Say nothing on the way: results and errors only");
}

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

bool is_standard_output(const std::string& path) {
    return path.empty() || path == "-";
}

void deliver(const std::string& text, const std::string& path, const std::string& input) {
    if (is_standard_output(path)) {
        fmt::print("{}", text);
        return;
    }
    refuse_to_overwrite(path, input);
    value_or_stop(write_text_file(path, text));
}

} // namespace experiment::commands
