// Decimal numbers exactly as they stand in a file.  A binary double cannot hold 0.1, and reading
// 1000000000000.4 as one leaves 4 digits of an F ratio; a decimal mantissa keeps them all.
#pragma once

#include "protocols/expected.h"

#include <string_view>

namespace analysis::numerics {

__extension__ typedef __int128 WideInteger;

/// mantissa times 10^exponent, exactly.
struct Decimal {
    WideInteger mantissa = 0; ///< at most 38 digits
    int exponent = 0;         ///< between -4000 and 4000
};

/// Reads sign, digits, point, digits and an optional e with its sign and digits: the whole of
/// `text`, whatever the locale.
/// Errors: a message naming the text, the column (from 1) and what would have been right.
protocols::Expected<Decimal> parse_decimal(std::string_view text);

} // namespace analysis::numerics
