// One program for one sitting.
#pragma once

#include "protocols/expected.h"

#include <filesystem>
#include <string>

namespace experiment::session {

/// Holds a file beside the votes that says "this sitting is taking place"; the system lets go of it
/// when the program ends, however it ends.
class SittingLock {
  public:
    /// Errors: another program holds it; the folder cannot be written.
    static protocols::Expected<SittingLock>
    take(const std::filesystem::path& folder, const std::string& observer, int session);

    ~SittingLock();
    SittingLock(SittingLock&& other) noexcept;
    SittingLock& operator=(SittingLock&&) = delete;

  private:
    SittingLock(int descriptor, std::filesystem::path file);

    int descriptor_;
    std::filesystem::path file_;
};

} // namespace experiment::session
