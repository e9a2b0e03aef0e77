// What the record of a sitting says, in words.
#include "experiment/report/sitting_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <map>

namespace experiment::report {

using store::Sitting;

namespace {

std::optional<int> number_at(const std::string& text, std::size_t at, std::size_t length) {
    int value = 0;
    if (text.size() < at + length)
        return {};
    const auto* end = text.data() + at + length;
    const auto read = std::from_chars(text.data() + at, end, value);
    return read.ec == std::errc{} && read.ptr == end ? std::optional(value) : std::nullopt;
}

// YYYY-MM-DDThh:mm:ss..., to the second.
std::optional<std::chrono::sys_seconds> time_point(const std::string& utc) {
    const auto year = number_at(utc, 0, 4);
    const auto month = number_at(utc, 5, 2);
    const auto day = number_at(utc, 8, 2);
    const auto hours = number_at(utc, 11, 2);
    const auto minutes = number_at(utc, 14, 2);
    const auto seconds = number_at(utc, 17, 2);
    if (!year || !month || !day || !hours || !minutes || !seconds)
        return {};
    const std::chrono::year_month_day date{std::chrono::year(*year),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day))};
    return std::chrono::sys_days(date) + std::chrono::hours(*hours) +
           std::chrono::minutes(*minutes) + std::chrono::seconds(*seconds);
}

int number_in(const std::string& facts, const std::string& name) {
    const auto text = value_in(facts, name);
    return number_at(text, 0, text.size()).value_or(0);
}

} // namespace

std::optional<std::string> known(std::string text) {
    return text.empty() ? std::nullopt : std::optional(std::move(text));
}

std::string joined(std::vector<std::string> parts) {
    std::erase(parts, "");
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string tallied(const std::vector<Sitting>& sittings,
                    const std::function<std::string(const Sitting&)>& text_of) {
    std::map<std::string, int> tally;
    for (const auto& sitting : sittings)
        if (const std::string text = text_of(sitting); !text.empty())
            ++tally[text];
    std::string lines;
    for (const auto& [text, count] : tally)
        lines += (lines.empty() ? "" : "\n") +
                 (tally.size() == 1
                      ? text
                      : fmt::format("{} ({} session{})", text, count, count == 1 ? "" : "s"));
    return lines;
}

std::string duration(const Sitting& sitting) {
    if (!sitting.finished_utc)
        return "";
    const auto start = time_point(sitting.start.started_utc);
    const auto end = time_point(*sitting.finished_utc);
    if (!start || !end || *end < *start)
        return "not known";
    const auto seconds = (*end - *start).count();
    return seconds < 60 ? fmt::format("{} s", seconds)
                        : fmt::format("{} min {} s", seconds / 60, seconds % 60);
}

std::string value_in(const std::string& facts, const std::string& name) {
    const auto all = "; " + facts;
    const auto begin = all.find("; " + name + "=");
    if (begin == std::string::npos)
        return "";
    const auto value = all.substr(begin + name.size() + 3);
    return value.substr(0, value.find("; "));
}

std::string last_word(const Sitting& sitting, const std::string& kind) {
    const auto last = std::find_if(sitting.events.rbegin(), sitting.events.rend(),
                                   [&](const auto& event) { return event.kind == kind; });
    return last == sitting.events.rend() ? "" : last->detail;
}

// A sitting that was stopped and taken up again is graded in parts; the letters sort from the best
// to the worst.
std::string timing_grade(const Sitting& sitting) {
    std::string worst;
    for (const auto& event : sitting.events)
        if (event.kind == "timing")
            worst = std::max(worst, value_in(event.detail, "grade"));
    return worst.empty() ? sitting.start.timing_grade : worst;
}

FrameCount frames_seen(const Sitting& sitting) {
    FrameCount count;
    for (const auto& event : sitting.events)
        if (event.kind == "timing") {
            count.all += number_in(event.detail, "frames");
            count.late += number_in(event.detail, "late");
        }
    return count;
}

std::string late_frames(const Sitting& sitting) {
    const auto [all, late] = frames_seen(sitting);
    return all == 0 || timing_grade(sitting) == "U" ? "" : fmt::format("{} of {}", late, all);
}

std::string overrides(const std::vector<Sitting>& sittings) {
    std::string lines;
    for (const auto& sitting : sittings)
        if (sitting.start.override_reason)
            lines += fmt::format("{}{}, session {}: {}", lines.empty() ? "" : "\n",
                                 sitting.start.key.observer.value, sitting.start.key.session,
                                 *sitting.start.override_reason);
    return lines;
}

} // namespace experiment::report
