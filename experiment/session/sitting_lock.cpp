// flock, which dies with its holder.
#include "experiment/session/sitting_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace experiment::session {

namespace {

// Between opening and locking, the last holder may have removed the file.
bool is_still_there(int descriptor, const std::filesystem::path& file) {
    struct stat held {};

    struct stat named {};

    return fstat(descriptor, &held) == 0 && stat(file.c_str(), &named) == 0 &&
           held.st_ino == named.st_ino;
}

} // namespace

protocols::Expected<SittingLock>
SittingLock::take(const std::filesystem::path& folder, const std::string& observer, int session) {
    const auto file = folder / fmt::format(".sitting-{}-{}.lock", observer, session);
    while (true) {
        const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
        if (descriptor < 0)
            return tl::unexpected(
                fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
        if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            close(descriptor);
            return tl::unexpected(fmt::format("session {} of observer {} is taking place in "
                                              "another program; expected it to end first",
                                              session, observer));
        }
        if (is_still_there(descriptor, file))
            return SittingLock(descriptor, file);
        close(descriptor);
    }
}

SittingLock::SittingLock(int descriptor, std::filesystem::path file)
    : descriptor_(descriptor), file_(std::move(file)) {}

SittingLock::SittingLock(SittingLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), file_(std::move(other.file_)) {}

SittingLock::~SittingLock() {
    if (descriptor_ < 0)
        return;
    unlink(file_.c_str());
    close(descriptor_);
}

} // namespace experiment::session
