// Whether text is UTF-8, as everything that is written is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace analysis {

/// The line (from 1) of the first byte that is no UTF-8; nothing when all is.
std::optional<std::int64_t> first_line_not_utf8(std::string_view text);

/// "" or "name:line: ..." with the remedy; a zero byte, which no text holds, is a fault as well.
std::string utf8_fault(std::string_view text, const std::string& name);

} // namespace analysis
