// Values as Python and JSON write them: what a data set consists of that is a script or a JSON
// file.  Nothing is executed.
#pragma once

#include "protocols/expected.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace analysis::formats {

struct Literal;

/// A key with its value, in the order of the file.
using LiteralEntry = std::pair<Literal, Literal>;

struct Literal {
    enum class Kind {
        None,   ///< None, null
        Truth,  ///< True, true, False, false: `number` is 1 or 0
        Number, ///< `number`
        Text,   ///< `text`
        List,   ///< [..] or (..): `items`
        Map     ///< {..}: `entries`
    };

    Kind kind = Kind::None;
    std::int64_t line = 0; ///< where it begins
    double number = 0;
    std::string text;
    std::vector<Literal> items;
    std::vector<LiteralEntry> entries;

    /// The value of a key that is this text; nothing when it is no map or has no such key.
    const Literal* find(std::string_view key) const;
};

/// One literal that is all of `text`, counted from line `first_line`.
/// Errors: `name:line: ...` for what is none, and for more than 100 brackets in one another.
protocols::Expected<Literal>
read_literal(std::string_view text, const std::string& name, std::int64_t first_line = 1);

/// Either one map, or lines `name = literal` as a script has them, as a map of those names.
protocols::Expected<Literal> read_literal_file(std::string_view text, const std::string& name);

} // namespace analysis::formats
