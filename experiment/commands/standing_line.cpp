// The experimenter's view of a sitting.
#include "experiment/commands/standing_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace experiment::commands {

std::string standing_text(const std::string& observer, const session::Standing& standing) {
    const auto seconds = standing.left.count();
    const auto left =
        seconds >= 90 ? fmt::format("{} min", (seconds + 30) / 60) : fmt::format("{} s", seconds);
    return fmt::format("{}: {}, {} of {} answered, about {} left", observer, standing.doing,
                       standing.answered, standing.main, left);
}

StandingLine::StandingLine(std::string observer, bool silent)
    : observer_(std::move(observer)), silent_(silent), terminal_(isatty(STDERR_FILENO) == 1) {}

StandingLine::~StandingLine() {
    if (terminal_ && width_ > 0)
        std::fputc('\n', stderr);
}

void StandingLine::update(const session::Standing& standing) {
    if (silent_)
        return;
    const auto text = standing_text(observer_, standing);
    if (terminal_) {
        width_ = std::max(width_, text.size());
        fmt::print(stderr, "\r{:<{}}", text, width_);
        std::fflush(stderr);
    } else if (doing_ != standing.doing) {
        fmt::print(stderr, "{}\n", text);
    }
    doing_ = standing.doing;
}

} // namespace experiment::commands
