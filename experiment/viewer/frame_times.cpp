// A second's worth of frames.
#include "experiment/viewer/frame_times.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace experiment::viewer {

void FrameTimes::add(double now, double milliseconds) {
    frames_.push_back({now, milliseconds});
    while (frames_.front().at < now - 1)
        frames_.pop_front();
}

std::optional<double> FrameTimes::median() const {
    if (frames_.empty())
        return std::nullopt;
    std::vector<double> times;
    for (const auto& frame : frames_)
        times.push_back(frame.milliseconds);
    std::ranges::sort(times);
    const std::size_t middle = times.size() / 2;
    return times.size() % 2 == 1 ? times[middle] : (times[middle - 1] + times[middle]) / 2;
}

} // namespace experiment::viewer
