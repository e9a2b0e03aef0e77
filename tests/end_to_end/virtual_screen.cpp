#include "tests/end_to_end/virtual_screen.h"

#include "renderer/imaging/image_files.h"
#include "tests/end_to_end/program.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace tests {

namespace {

[[noreturn]] void become(std::vector<std::string> command) {
    std::vector<char*> arguments;
    for (auto& word : command)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

/// A number that no other test has.  Whoever lets servers look for a free one gets that of a server
/// just ending, which then takes the new one's socket away with its own.
int own_display() {
    return 1000 + getpid() % 50000;
}

} // namespace

VirtualScreen::VirtualScreen(int width, int height) {
    const auto display = fmt::format(":{}", own_display());
    int ends[2];
    if (pipe(ends) != 0)
        throw std::runtime_error("no pipe");
    server_ = fork();
    if (server_ == 0) {
        close(ends[0]);
        const int silence = open("/dev/null", O_WRONLY);
        dup2(silence, STDERR_FILENO);
        // Without -noreset the server starts anew whenever its last client goes, as every xdotool
        // does, and turns away whoever connects at that moment.
        become({"Xvfb", display, "-displayfd", fmt::format("{}", ends[1]), "-screen", "0",
                fmt::format("{}x{}x24", width, height), "-nolisten", "tcp", "-noreset"});
    }
    close(ends[1]);
    std::string number;
    for (char character = 0; read(ends[0], &character, 1) == 1 && character != '\n';)
        number += character;
    close(ends[0]);
    if (number.empty())
        throw std::runtime_error("Xvfb did not start; tools/install-dependencies brings it");
    setenv("DISPLAY", display.c_str(), 1);
}

VirtualScreen::~VirtualScreen() {
    unsetenv("DISPLAY");
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
}

void VirtualScreen::press(const std::string& key) const {
    run({"xdotool", "key", key});
}

void VirtualScreen::click(int x, int y) const {
    run({"xdotool", "mousemove", fmt::format("{}", x), fmt::format("{}", y), "click", "1"});
}

renderer::imaging::EncodedImage VirtualScreen::photograph() const {
    const TemporaryFolder folder;
    const auto file = folder / "screen.png";
    run({"import", "-silent", "-window", "root", "-depth", "8", "-define", "png:color-type=2",
         file.string()});
    const auto read = renderer::imaging::read_encoded(file);
    if (!read)
        throw std::runtime_error(read.error());
    return read->image;
}

Typist::Typist() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ == 0) {
        dup2(ends[0], STDIN_FILENO);
        become({"xdotool", "-"});
    }
    close(ends[0]);
    commands_ = ends[1];
}

Typist::~Typist() {
    close(commands_); // its input ends, and so does it
    waitpid(process_, nullptr, 0);
}

void Typist::press(const std::string& key) {
    const auto command = "key --delay 0 " + key + "\n";
    if (write(commands_, command.data(), command.size()) != static_cast<ssize_t>(command.size()))
        throw std::runtime_error("xdotool takes no commands");
}

RunningProgram::RunningProgram(const std::vector<std::string>& command, const std::string& err_file)
    : process_(fork()) {
    if (process_ != 0)
        return;
    dup2(open(err_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    dup2(open("/dev/null", O_RDWR), STDIN_FILENO);
    dup2(STDIN_FILENO, STDOUT_FILENO);
    become(command);
}

RunningProgram::~RunningProgram() {
    if (is_running())
        kill_at_once();
}

bool RunningProgram::is_running() {
    int status = 0;
    if (process_ < 0 || waitpid(process_, &status, WNOHANG) == 0)
        return process_ >= 0;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    process_ = -1;
    return false;
}

void RunningProgram::kill_at_once() {
    int status = 0;
    kill(process_, SIGKILL);
    waitpid(process_, &status, 0);
    status_ = 128 + SIGKILL;
    process_ = -1;
}

} // namespace tests
