// Clocks and dates.
#include "experiment/session/clock.h"

#include "protocols/contract.h"

#include <fmt/format.h>

#include <cstdio>
#include <ctime>

namespace experiment::session {

using std::chrono::duration_cast;

Monotonic SystemClock::now() const {
    return duration_cast<Monotonic>(std::chrono::steady_clock::now().time_since_epoch());
}

WallTime SystemClock::wall() const {
    return std::chrono::system_clock::now();
}

WallTime VirtualClock::wall() const {
    return start_ + duration_cast<WallTime::duration>(now_);
}

std::string utc_text(WallTime time) {
    using namespace std::chrono;
    const auto day = floor<days>(time);
    const year_month_day date(day);
    const hh_mm_ss clock(floor<milliseconds>(time - day));
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                       clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
                       clock.subseconds().count());
}

std::string local_date(WallTime time) {
    const auto seconds = std::chrono::system_clock::to_time_t(time);
    std::tm local{};
    EXPECTS(localtime_r(&seconds, &local) != nullptr);
    return fmt::format("{:04}-{:02}-{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday);
}

int days_between(const std::string& from, const std::string& to) {
    const auto day_of = [](const std::string& text) {
        int year = 0;
        unsigned month = 0, day = 0;
        EXPECTS(std::sscanf(text.c_str(), "%4d-%2u-%2u", &year, &month, &day) == 3);
        return std::chrono::sys_days(std::chrono::year(year) / std::chrono::month(month) /
                                     std::chrono::day(day));
    };
    return static_cast<int>((day_of(to) - day_of(from)).count());
}

} // namespace experiment::session
