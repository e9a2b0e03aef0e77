// The two clocks of a sitting: one that only goes forward, and one on the wall.
#pragma once

#include "experiment/session/inputs.h"

#include <chrono>
#include <string>

namespace experiment::session {

using WallTime = std::chrono::system_clock::time_point;

class Clock {
  public:
    virtual ~Clock() = default;
    virtual Monotonic now() const = 0;
    virtual WallTime wall() const = 0;
};

/// The machine's own.
class SystemClock final : public Clock {
  public:
    Monotonic now() const override;
    WallTime wall() const override;
};

/// A clock that goes when it is told to; its wall clock goes along from `start`.
class VirtualClock final : public Clock {
  public:
    explicit VirtualClock(WallTime start) : start_(start) {}

    Monotonic now() const override { return now_; }

    WallTime wall() const override;

    void advance(Monotonic duration) { now_ += duration; }

  private:
    WallTime start_;
    Monotonic now_{};
};

/// ISO 8601 with milliseconds: 2026-03-01T09:00:00.123Z
std::string utc_text(WallTime time);

/// YYYY-MM-DD in the machine's time zone.
std::string local_date(WallTime time);

/// Calendar days from one YYYY-MM-DD to another.  EXPECTS both to be dates.
int days_between(const std::string& from, const std::string& to);

} // namespace experiment::session
