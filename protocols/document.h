// A TOML text as plain values that remember their lines.
#pragma once

#include "protocols/expected.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace protocols {

struct Node;
struct Entry;

/// A date or a time: our files have no use for them.
struct Moment {};

struct Node {
    std::variant<std::string,
                 std::int64_t,
                 double,
                 bool,
                 Moment,
                 std::vector<Node>,
                 std::vector<Entry>>
        value;
    int line = 1;
};

/// A key of a table, at its own line.
struct Entry {
    std::string key;
    int line = 1;
    Node node;
};

using List = std::vector<Node>;
using Table = std::vector<Entry>;

/// The text's outermost table.  Errors: "<file_name>:<line>: not TOML: <what>".
Expected<Table> read_document(std::string_view text, std::string_view file_name);

/// As a person would write it in a message: "text", 4, 0.5, true, ["a", "b"] (the first four of a
/// longer list), a table.
std::string shown(const Node& node);

} // namespace protocols
