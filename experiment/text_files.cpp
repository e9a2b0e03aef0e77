// C streams underneath, because they say why they failed (errno).
#include "experiment/text_files.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace experiment {

namespace fs = std::filesystem;

namespace {

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

using File = std::unique_ptr<std::FILE, Close>;

std::string reason() {
    return std::generic_category().message(errno);
}

tl::unexpected<std::string> cannot(const char* what, const fs::path& path, const std::string& why) {
    return tl::unexpected(fmt::format("{}: cannot be {}: {}", path.string(), what, why));
}

tl::expected<void, std::string> write_into(const fs::path& path, std::string_view text) {
    const File file(std::fopen(path.c_str(), "wb"));
    if (!file)
        return cannot("written", path, reason());
    if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
        std::fflush(file.get()) != 0)
        return cannot("written", path, reason());
    return {};
}

} // namespace

tl::expected<std::string, std::string> read_text_file(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        return cannot("read", path, "it is a folder");
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file)
        return cannot("read", path, reason());
    std::string text;
    char block[1 << 16];
    while (const auto count = std::fread(block, 1, sizeof block, file.get()))
        text.append(block, count);
    if (std::ferror(file.get()))
        return cannot("read", path, reason());
    return text;
}

tl::expected<void, std::string> write_text_file(const fs::path& path, std::string_view text) {
    std::error_code failure;
    if (const auto there = fs::status(path, failure);
        fs::exists(there) && !fs::is_regular_file(there))
        return write_into(path, text); // a device or a pipe stays what it is
    failure.clear();
    if (path.has_parent_path())
        fs::create_directories(path.parent_path(), failure);
    if (failure)
        return cannot("written", path, failure.message());
    const fs::path temporary = fmt::format("{}.{}.part", path.string(), getpid());
    File file(std::fopen(temporary.c_str(), "wb"));
    if (!file)
        return cannot("written", path, reason());
    const bool complete = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size() &&
                          std::fflush(file.get()) == 0 && fsync(fileno(file.get())) == 0;
    const auto why = complete ? std::string() : reason();
    file.reset();
    if (complete)
        fs::rename(temporary, path, failure);
    if (complete && !failure)
        return {};
    std::error_code ignored;
    fs::remove(temporary, ignored);
    return cannot("written", path, complete ? failure.message() : why);
}

} // namespace experiment
