// A JSON text as plain values that remember their lines, and how they are read with a reason when
// they are not what is wanted.
#pragma once

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace experiment {

struct JsonMember;

struct JsonValue {
    std::variant<std::monostate, ///< null
                 bool,
                 std::uint64_t,
                 std::int64_t, ///< below 0
                 double,
                 std::string,
                 std::vector<JsonValue>,
                 std::vector<JsonMember>>
        value;
    int line = 1;
};

struct JsonMember {
    std::string key;
    JsonValue value;
};

/// Reads a whole text, which may begin with a byte-order mark.
/// Errors: "<file_name>:<line>: ..." for what is no JSON, no UTF-8 or has a zero byte in it, a key
/// that stands twice in one object, a number that no double holds, and more than 64 levels.
tl::expected<JsonValue, std::string> read_json(std::string_view text, std::string_view file_name);

/// What a value should have been; thrown while reading, caught by `read_json_as`.
struct JsonMisfit : std::runtime_error {
    JsonMisfit(int where, const std::string& what) : std::runtime_error(what), line(where) {}

    int line;
};

/// A value and the way to it, such as scenes[0].rows[3].
class JsonPlace {
  public:
    JsonPlace(const JsonValue& value, std::string way) : value_(&value), way_(std::move(way)) {}

    // All throw JsonMisfit when the value is something else.
    bool has(std::string_view key) const;
    JsonPlace at(std::string_view key) const;
    std::vector<JsonPlace> elements() const;
    std::vector<std::pair<std::string, JsonPlace>> members() const;
    std::string text() const;
    double number() const;
    int count() const;        ///< from 0, as far as an int goes
    std::size_t size() const; ///< from 0: bytes may be more than an int holds

    [[noreturn]] void refuse(std::string_view wanted) const;
    [[noreturn]] void complain(std::string_view what) const;

  private:
    const std::vector<JsonMember>& object() const;
    const JsonValue* find(std::string_view key) const;
    std::string way_to(std::string_view key) const;

    const JsonValue* value_;
    std::string way_;
};

/// What `read` makes of the text's outermost value.
/// Errors: those of `read_json` and what `read` throws, as "<file_name>:<line>: ...; <remedy>".
template <class Read>
auto read_json_as(std::string_view text,
                  std::string_view file_name,
                  const std::string& remedy,
                  Read read)
    -> tl::expected<decltype(read(std::declval<JsonPlace>())), std::string> {
    const auto json = read_json(text, file_name);
    if (!json)
        return tl::unexpected(json.error() + "; " + remedy);
    try {
        return read(JsonPlace(*json, ""));
    } catch (const JsonMisfit& misfit) {
        return tl::unexpected(std::string(file_name) + ":" + std::to_string(misfit.line) + ": " +
                              misfit.what() + "; " + remedy);
    }
}

} // namespace experiment
