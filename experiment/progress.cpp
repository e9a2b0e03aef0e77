// The bar is redrawn at most ten times a second and wiped when the work is done.
#include "experiment/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace experiment {

namespace {

using namespace std::chrono_literals;

constexpr int bar_width = 30;

} // namespace

ProgressBar::ProgressBar(std::string label, bool enabled)
    : label_(std::move(label)), enabled_(enabled && isatty(STDERR_FILENO) != 0),
      start_(Clock::now()), last_drawn_(start_) {}

ProgressBar::~ProgressBar() {
    if (drawn_)
        fmt::print(stderr, "\r\033[K");
}

void ProgressBar::update(double fraction) {
    const auto now = Clock::now();
    if (!enabled_ || now - start_ < 1s || (drawn_ && now - last_drawn_ < 100ms))
        return;
    last_drawn_ = now;
    drawn_ = true;
    fraction = std::clamp(fraction, 1e-3, 1.0);
    const auto left = std::chrono::duration_cast<std::chrono::seconds>(
        (now - start_) * ((1.0 - fraction) / fraction));
    const int filled = static_cast<int>(fraction * bar_width);
    fmt::print(stderr, "\r\033[K{} [{:=<{}}{:<{}}] {:3.0f} %, {} left", label_, "", filled, "",
               bar_width - filled, 100.0 * fraction, spoken_duration(left));
    std::fflush(stderr);
}

std::string spoken_duration(std::chrono::seconds time) {
    const auto seconds = time.count();
    return seconds < 60 ? fmt::format("{} s", seconds)
                        : fmt::format("{} min {:02} s", seconds / 60, seconds % 60);
}

} // namespace experiment
