// Swaps, judged.
#include "experiment/session/timing.h"

#include "protocols/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace experiment::session {

namespace {

constexpr int enough_frames = 100; // fewer say nothing about one late frame in a thousand

double in_ms(Monotonic duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
}

double median_ms(std::span<const Monotonic> intervals) {
    std::vector<Monotonic> sorted(intervals.begin(), intervals.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return in_ms(*middle);
}

SwapVerdict verdict_of(const SwapTest& test) {
    if (!(test.nominal_ms > 0))
        return SwapVerdict::Unsynced;
    const double ratio = test.mean_ms / test.nominal_ms;
    if (std::abs(ratio - 1) <= 0.01 && test.late == 0)
        return SwapVerdict::Synced;
    if (ratio < 0.8)
        return SwapVerdict::Unsynced;
    return std::abs(ratio - 2) <= 0.05 ? SwapVerdict::HalfRate : SwapVerdict::Unstable;
}

} // namespace

SwapTest judge_swaps(std::span<const Monotonic> intervals, double nominal_hz) {
    EXPECTS(!intervals.empty());
    SwapTest test;
    test.intervals = static_cast<int>(intervals.size());
    test.nominal_ms = nominal_hz > 0 ? 1000 / nominal_hz : 0;
    const auto [least, greatest] = std::minmax_element(intervals.begin(), intervals.end());
    test.least_ms = in_ms(*least);
    test.greatest_ms = in_ms(*greatest);
    for (const auto interval : intervals)
        test.mean_ms += in_ms(interval) / test.intervals;
    double squares = 0;
    for (const auto interval : intervals)
        squares += std::pow(in_ms(interval) - test.mean_ms, 2);
    test.sd_ms = std::sqrt(squares / std::max(1, test.intervals - 1));
    const double limit = 1.5 * median_ms(intervals);
    test.late =
        static_cast<int>(std::count_if(intervals.begin(), intervals.end(),
                                       [&](auto interval) { return in_ms(interval) > limit; }));
    test.verdict = verdict_of(test);
    return test;
}

std::string name_of(SwapVerdict verdict) {
    switch (verdict) {
    case SwapVerdict::Synced:
        return "synced";
    case SwapVerdict::Unsynced:
        return "unsynced";
    case SwapVerdict::HalfRate:
        return "half rate";
    case SwapVerdict::Unstable:
        return "unstable";
    }
    return {};
}

std::string text_of(const SwapTest& test) {
    return fmt::format("{}: mean {:.2f} ms, sd {:.2f}, {:.2f} to {:.2f}, {} of {} late, nominal {}",
                       name_of(test.verdict), test.mean_ms, test.sd_ms, test.least_ms,
                       test.greatest_ms, test.late, test.intervals,
                       test.nominal_ms > 0 ? fmt::format("{:.2f}", test.nominal_ms)
                                           : "not reported");
}

std::string timing_grade(const DisplayTiming& display, int frames, int late) {
    if (display.kind == DisplayKind::Virtual || display.verdict != SwapVerdict::Synced)
        return "U";
    const bool few_late = frames >= enough_frames && late * 1000 <= frames;
    return few_late && display.kind == DisplayKind::FullScreen ? "B" : "C";
}

std::string provisional_grade(const DisplayTiming& display) {
    return timing_grade(display, 0, 0);
}

} // namespace experiment::session
