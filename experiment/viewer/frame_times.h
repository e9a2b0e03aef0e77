// How long pictures took of late.
#pragma once

#include <deque>
#include <optional>

namespace experiment::viewer {

class FrameTimes {
  public:
    /// A picture that was finished at `now` (seconds of any steady clock) took `milliseconds`.
    void add(double now, double milliseconds);

    /// The median over the second before the last picture; the mean of the middle two where their
    /// number is even; nothing before the first.
    std::optional<double> median() const;

  private:
    struct Frame {
        double at, milliseconds;
    };

    std::deque<Frame> frames_;
};

} // namespace experiment::viewer
