// How well a display keeps time, judged from the moments at which its buffers were swapped.
#pragma once

#include "experiment/session/inputs.h"

#include <span>
#include <string>

namespace experiment::session {

enum class SwapVerdict {
    Synced,   ///< swaps wait for the display: mean within 1 % of nominal, none late
    Unsynced, ///< they do not: a virtual screen, or a driver told not to wait
    HalfRate, ///< they wait twice: a known fault of compositors
    Unstable  ///< anything else
};

/// What a series of swaps looked like.
struct SwapTest {
    int intervals = 0;
    double mean_ms = 0, sd_ms = 0, least_ms = 0, greatest_ms = 0;
    int late = 0; ///< longer than 1.5 times the median
    double nominal_ms = 0;
    SwapVerdict verdict = SwapVerdict::Unstable;
};

/// EXPECTS intervals and a nominal refresh above 0.  Without one (0), nothing is synced.
SwapTest judge_swaps(std::span<const Monotonic> intervals, double nominal_hz);

/// "synced", "unsynced", ...
std::string name_of(SwapVerdict verdict);

/// "unsynced: mean 3.1 ms, sd 0.4, 2.8 to 5.0, 1 of 599 late, nominal 16.67"
std::string text_of(const SwapTest& test);

/// Whether the pictures reach a monitor at all.
enum class DisplayKind { Virtual, Windowed, FullScreen };

/// What is known of a display before a sitting's own frames are counted.
struct DisplayTiming {
    SwapVerdict verdict = SwapVerdict::Unstable;
    DisplayKind kind = DisplayKind::Virtual;
};

/// The grade of a sitting whose frames were seen: B (swaps return when the display shows them, at
/// most 0.1 % of frames late), C (synced, but more are late, or in a window), U (unverified: a
/// virtual display, or one that did not pass the test).  A would need the system's own time of
/// presentation, which this program does not ask for.
std::string timing_grade(const DisplayTiming& display, int frames, int late);

/// What can be promised before the sitting: C where it may still become B.
std::string provisional_grade(const DisplayTiming& display);

} // namespace experiment::session
