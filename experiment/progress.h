// A progress bar with the time left, on a terminal only.
#pragma once

#include <chrono>
#include <string>

namespace experiment {

/// Draws on standard error when that is a terminal and the work takes longer than a second.
class ProgressBar {
  public:
    /// `enabled` false keeps it silent everywhere (--quiet).
    ProgressBar(std::string label, bool enabled);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// `fraction` of the work is done, 0..1.
    void update(double fraction);

  private:
    using Clock = std::chrono::steady_clock;

    std::string label_;
    bool enabled_ = false;
    bool drawn_ = false;
    Clock::time_point start_;
    Clock::time_point last_drawn_;
};

/// "38 s", "2 min 05 s": how long `time` is, for a person.
std::string spoken_duration(std::chrono::seconds time);

} // namespace experiment
