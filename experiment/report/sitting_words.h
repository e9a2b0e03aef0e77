// What the record of a sitting says, in words.
#pragma once

#include "experiment/store/records.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace experiment::report {

/// Nothing where there is nothing to say; it is printed as "not recorded".
std::optional<std::string> known(std::string text);

/// What there is of the parts, between commas.
std::string joined(std::vector<std::string> parts);

/// What differs between sittings, each once, with how often when there are several.
std::string tallied(const std::vector<store::Sitting>& sittings,
                    const std::function<std::string(const store::Sitting&)>& text_of);

/// "12 min 5 s"; "" of a sitting that was not finished.
std::string duration(const store::Sitting& sitting);

/// The value of `name` in "name=value; name=value"; "" where it is not there.
std::string value_in(const std::string& facts, const std::string& name);

/// What the last event of that kind says; "" where there is none.
std::string last_word(const store::Sitting& sitting, const std::string& kind);

/// The grade at the end, with its frames counted; before that, what could be promised.
std::string timing_grade(const store::Sitting& sitting);

struct FrameCount {
    int all = 0, late = 0;
};

/// As counted until the sitting ended, or was stopped.
FrameCount frames_seen(const store::Sitting& sitting);

/// "4 of 300"; "" where nothing can be late, because the display's timing is unverified.
std::string late_frames(const store::Sitting& sitting);

/// Who sat sooner than the study allows, and why, a line each.
std::string overrides(const std::vector<store::Sitting>& sittings);

} // namespace experiment::report
