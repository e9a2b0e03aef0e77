// Names first, then numbers.
#include "experiment/viewer/dial_steps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace experiment::viewer {

using renderer::methods::Dial;
using renderer::methods::DialValue;

namespace {

constexpr std::int64_t widest_by_one = 64;
constexpr double widest_by_twentieths = 10; // of the preset
constexpr double factor = 1.25;
constexpr double least_share = 1e-3; // of the preset: below it a shrinking number is at its end

std::int64_t next_whole(const Dial& dial, std::int64_t now, int by) {
    const auto [least, most] = *dial.whole;
    if (most - least <= widest_by_one)
        return std::clamp(now + (by > 0 ? 1 : -1), least, most);
    const auto moved = by > 0 ? std::max<std::int64_t>(2 * now, 1) : now / 2;
    return std::clamp(moved, least, most);
}

double next_number(const Dial& dial, double now, int by) {
    const auto [least, most] = *dial.number;
    const auto* preset = std::get_if<double>(&dial.preset);
    const double usual = preset != nullptr ? std::abs(*preset) : 0;
    if (!(usual > 0) || most - least <= widest_by_twentieths * usual)
        return std::clamp(now + (by > 0 ? 1 : -1) * (most - least) / 20, least, most);
    if (now < least_share * usual)
        return by > 0 ? std::max(least_share * usual, least) : least;
    return std::clamp(by > 0 ? now * factor : now / factor, least, most);
}

/// The first number above the names: the preset where that is one, else the least.
std::optional<DialValue> first_number(const Dial& dial) {
    if (dial.whole)
        return dial.whole->least;
    if (dial.number)
        return std::holds_alternative<double>(dial.preset) ? dial.preset
                                                           : DialValue{dial.number->least};
    return std::nullopt;
}

DialValue next_name(const Dial& dial, const std::string& now, int by) {
    const auto count = static_cast<std::ptrdiff_t>(dial.names.size());
    const auto place = std::find(dial.names.begin(), dial.names.end(), now) - dial.names.begin();
    const auto next = place + (by > 0 ? 1 : -1);
    const auto number = first_number(dial);
    if (number && next >= count)
        return *number;
    if (number && next < 0)
        return now;
    return dial.names[static_cast<std::size_t>((next + count) % count)];
}

} // namespace

DialValue stepped(const Dial& dial, const DialValue& now, int by) {
    if (const auto* name = std::get_if<std::string>(&now))
        return next_name(dial, *name, by);
    DialValue next = now;
    if (const auto* whole = std::get_if<std::int64_t>(&now))
        next = next_whole(dial, *whole, by);
    else
        next = next_number(dial, std::get<double>(now), by);
    if (by < 0 && next == now && !dial.names.empty())
        return dial.names.back();
    return next;
}

} // namespace experiment::viewer
