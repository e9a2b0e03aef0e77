#include "analysis/utf8.h"

#include <fmt/format.h>

#include <algorithm>

namespace analysis {

namespace {

// Bytes of the character that begins with `first`; 0 when none does.
std::size_t length_of(unsigned char first) {
    if (first < 0x80)
        return 1;
    if (first >= 0xC2 && first < 0xE0)
        return 2;
    if (first >= 0xE0 && first < 0xF0)
        return 3;
    return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

// Overlong forms and surrogates are told by the second byte.
bool second_fits(unsigned char first, unsigned char second) {
    switch (first) {
    case 0xE0:
        return second >= 0xA0;
    case 0xED:
        return second < 0xA0;
    case 0xF0:
        return second >= 0x90;
    case 0xF4:
        return second < 0x90;
    default:
        return true;
    }
}

std::int64_t line_of(std::string_view text, std::size_t place) {
    return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n');
}

} // namespace

std::optional<std::int64_t> first_line_not_utf8(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    for (std::size_t at = 0; at < text.size();) {
        const auto length = length_of(byte(at));
        bool good = length > 0 && at + length <= text.size();
        for (std::size_t k = 1; good && k < length; ++k)
            good = (byte(at + k) & 0xC0) == 0x80 && (k > 1 || second_fits(byte(at), byte(at + 1)));
        if (!good)
            return line_of(text, at);
        at += length;
    }
    return std::nullopt;
}

std::string utf8_fault(std::string_view text, const std::string& name) {
    if (const auto line = first_line_not_utf8(text))
        return fmt::format("{}:{}: a byte that is no UTF-8; save the file as UTF-8", name, *line);
    if (const auto zero = text.find('\0'); zero != text.npos)
        return fmt::format("{}:{}: a zero byte; save the file as text", name, line_of(text, zero));
    return {};
}

} // namespace analysis
