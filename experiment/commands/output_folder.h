// A folder for results, before they are worked out.
#pragma once

#include <filesystem>

namespace experiment::commands {

/// That a folder can be written, or made.  Nothing is made: what is refused later should leave
/// nothing behind.
/// Errors: CommandError with the folder and the reason.
void expect_writable(const std::filesystem::path& folder);

} // namespace experiment::commands
