// The three streams of the child are unnamed files: whatever their sizes, nobody waits for anybody.
#include "experiment/report/gnuplot.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace experiment::report {

namespace {

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

using File = std::unique_ptr<std::FILE, Close>;

std::string everything_in(std::FILE* file) {
    std::string text;
    std::array<char, 1 << 14> block{};
    std::rewind(file);
    while (const auto count = std::fread(block.data(), 1, block.size(), file))
        text.append(block.data(), count);
    return text;
}

// gnuplot quotes the offending line before it says what is wrong with it: the words come last.
std::string complaint(const std::string& text) {
    std::string last;
    std::size_t from = 0;
    while (from < text.size()) {
        const auto end = std::min(text.find('\n', from), text.size());
        const auto first = text.find_first_not_of(" \t^", from);
        if (first < end)
            last = text.substr(first, end - first);
        from = end + 1;
    }
    return last.empty() ? "without a word" : last;
}

// 0, or the error number.  `status` is the child's exit status, -1 when a signal ended it.
int spawn_and_wait(const std::string& program, const std::array<int, 3>& streams, int& status) {
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    for (int stream = 0; stream < 3; ++stream)
        posix_spawn_file_actions_adddup2(&actions, streams[static_cast<std::size_t>(stream)],
                                         stream);
    std::string name = program;
    std::string no_start_up_files = "-d";
    std::string from_input = "-";
    std::array<char*, 4> arguments{name.data(), no_start_up_files.data(), from_input.data(),
                                   nullptr};
    pid_t child = 0;
    const int failure =
        posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0)
        return failure;
    int ending = 0;
    while (waitpid(child, &ending, 0) < 0)
        if (errno != EINTR)
            return errno;
    status = WIFEXITED(ending) ? WEXITSTATUS(ending) : -1;
    return 0;
}

} // namespace

tl::expected<std::string, std::string> run_gnuplot(std::string_view script,
                                                   const std::string& program) {
    const File input(std::tmpfile());
    const File output(std::tmpfile());
    const File errors(std::tmpfile());
    if (!input || !output || !errors ||
        std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() ||
        std::fflush(input.get()) != 0 || lseek(fileno(input.get()), 0, SEEK_SET) != 0)
        return tl::unexpected(
            fmt::format("temporary files for {}: {}", program, std::strerror(errno)));

    int status = 0;
    const int failure = spawn_and_wait(
        program, {fileno(input.get()), fileno(output.get()), fileno(errors.get())}, status);
    if (failure == ENOENT)
        return tl::unexpected(fmt::format(
            "{}: there is no such program, and figures are drawn by it; install the package "
            "gnuplot-nox, or run tools/install-dependencies",
            program));
    if (failure != 0)
        return tl::unexpected(fmt::format("{}: {}", program, std::strerror(failure)));
    if (status != 0)
        return tl::unexpected(fmt::format("{} failed with status {}: {}", program, status,
                                          complaint(everything_in(errors.get()))));
    return everything_in(output.get());
}

// gnuplot 5.4 misreads a doubled quote at the beginning of a string, so none is ever written.
std::string gnuplot_string(std::string_view text) {
    std::string quoted = "'";
    for (const char character : text)
        if (character == '\'')
            quoted += "\u2019";
        else
            quoted += static_cast<unsigned char>(character) < 0x20 ? ' ' : character;
    return quoted + "'";
}

} // namespace experiment::report
