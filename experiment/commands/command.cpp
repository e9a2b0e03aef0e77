// Remarks go to standard error, results to standard output.
#include "experiment/commands/command.h"

#include "experiment/text_files.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace experiment::commands {

void Voice::remark(const std::string& text) const {
    if (!quiet)
        fmt::print(stderr, "{}\n", text);
}

void add_voice(CLI::App& command, Voice& voice) {
    command.add_flag("-q,--quiet", voice.quiet, "Say nothing on the way: results and errors only");
}

void deliver(const std::string& text, const std::string& path) {
    if (path.empty())
        fmt::print("{}", text);
    else
        value_or_stop(write_text_file(path, text));
}

} // namespace experiment::commands
