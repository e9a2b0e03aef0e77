// Runs the real program, as a person would, and keeps what it said.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tests {

struct Outcome {
    int status = -1; ///< exit status; 128 + signal when it was killed
    std::string out;
    std::string err;
};

/// Runs `command` (found on PATH when it has no slash) to its end.
Outcome run(const std::vector<std::string>& command);

/// Runs pairlight with `arguments`.
Outcome pairlight(const std::vector<std::string>& arguments);

/// A folder that is gone with its owner.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& text);

} // namespace tests
