// Comma-separated text as RFC 4180 has it: quotes, doubled quotes, line breaks inside quotes, CRLF,
// and the byte-order mark that spreadsheets put in front.  Fields are apart by commas, by tabs
// where the first line has one, or by semicolons where it has those and no comma.
#pragma once

#include "protocols/expected.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace analysis {

/// What is wrong with a record; "" when nothing is.
using RecordReader =
    std::function<std::string(std::int64_t line, std::span<const std::string_view> fields)>;

/// Calls `record` for every record of `text`, the header included, with the line it begins on.
/// Blank lines are passed over.  The views last for the call.
/// Errors: `name:line: ...` for a quote that does not close, for text after a closing quote, and
/// for what `record` finds wrong; reading stops there.
protocols::Expected<std::int64_t>
read_csv(std::string_view text, const std::string& name, const RecordReader& record);

/// One field, quoted when it must be.
std::string csv_field(std::string_view text);

} // namespace analysis
