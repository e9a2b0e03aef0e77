// What is not there yet is made in the nearest folder that is.
#include "experiment/commands/output_folder.h"

#include "experiment/commands/command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace experiment::commands {

namespace fs = std::filesystem;

void expect_writable(const fs::path& folder) {
    std::error_code ignored;
    auto there = fs::absolute(folder, ignored);
    while (!fs::exists(there, ignored) && there.has_relative_path())
        there = there.parent_path();
    const auto* why = !fs::is_directory(there, ignored)           ? std::strerror(ENOTDIR)
                      : ::access(there.c_str(), W_OK | X_OK) != 0 ? std::strerror(errno)
                                                                  : nullptr;
    if (why != nullptr)
        throw CommandError(fmt::format("{}: nothing can be written there ({}); name another folder "
                                       "with --out",
                                       folder.string(), why));
}

} // namespace experiment::commands
